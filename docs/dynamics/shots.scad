// A house, and a camera that comes nearer and turns about it while $t runs from 0 to 1.
$vpt = [4 * $t, 0, 10 + 3 * $t];
$vpr = [75 - 10 * $t, 0, 20 + 70 * $t];
$vpd = 150 - 90 * $t;

module house() {
  cube([30, 20, 15]);
  translate([0, 0, 15]) rotate([90, 0, 90]) linear_extrude(30) polygon([[-1, 0], [21, 0], [10, 9]]);
}
module tree() { cylinder(h = 6, r = 1); translate([0, 0, 5]) cylinder(h = 14, r1 = 5, r2 = 0); }

color("#d8c8a0") translate([-15, -10, 0]) house();
color("#508050") for (p = [[24, -6], [22, 12], [-24, 9]]) translate(p) tree();
color("#c0c0b0") translate([-45, -35, -1]) cube([90, 70, 1]);
