// A cabinet whose drawer opens and whose door swings.
module cabinet() difference() {
  cube([60, 40, 70]);
  translate([3, -1, 3]) cube([54, 38, 40]);
  translate([3, -1, 46]) cube([54, 38, 21]);
}
module drawer() difference() {
  union() { cube([53, 36, 19]); translate([-2, -2, -1]) cube([57, 2, 21]); }
  translate([2, 2, 2]) cube([49, 32, 30]);
}
module door() { cube([28, 2, 40]); translate([24, -2, 18]) cylinder(h = 6, r = 1.2, $fn = 24); }

color("#c0a070") cabinet();
color("#90b0a0") translate([3.5, 30 * (cos(180 * $t) - 1) / 2, 47]) drawer();
color("#a08060") translate([2, -2, 3]) rotate(-100 * $t) door();
color("#a08060") translate([58, -2, 3]) mirror([1, 0, 0]) rotate(-100 * $t) door();
