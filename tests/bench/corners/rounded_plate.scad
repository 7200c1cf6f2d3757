// A plate with holes, its edges rounded in plan by a disc of no height.
$fn = 48;
minkowski() {
    difference() {
        hull() for (x = [-20, 20], y = [-10, 10]) translate([x, y, 0]) cylinder(r = 5, h = 4);
        for (x = [-15 : 5 : 15], y = [-10 : 5 : 10]) translate([x, y, -1]) cylinder(r = 1.5 + x * x / 1000, h = 20);
    }
    cylinder(r = 0.5, h = 1e-7);
}
