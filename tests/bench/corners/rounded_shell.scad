// A shell with rounded corners, open above, bored, rounded once more.
$fn = 36;
minkowski() {
    difference() {
        minkowski() { cube([60, 40, 20], center = true); cylinder(r = 3, h = 1); }
        translate([0, 0, 2]) minkowski() { cube([56, 36, 20], center = true); cylinder(r = 3, h = 1); }
        rotate([90, 0, 0]) for (i = [-20 : 10 : 20]) translate([i, 0, 0]) cylinder(d = 5, h = 100, center = true);
    }
    sphere(0.7);
}
