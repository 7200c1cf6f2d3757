// A hollow box with posts, vents and a hole for a cable, rounded by a ball, or with tool = "disc" by a disc.
$fn = 32;
tool = "ball";
minkowski() {
    difference() {
        union() {
            difference() { cube([80, 50, 25]); translate([3, 3, 3]) cube([74, 44, 30]); }
            for (x = [8, 72], y = [8, 42]) translate([x, y, 0]) cylinder(r = 4, h = 20);
        }
        for (x = [8, 72], y = [8, 42]) translate([x, y, 5]) cylinder(r = 1.7, h = 30);
        for (i = [0 : 6]) translate([20 + i * 6, -1, 8]) cube([3, 6, 10]);
        translate([40, 60, 12]) rotate([90, 0, 0]) cylinder(r = 6, h = 20);
    }
    if (tool == "ball") sphere(r = 1, $fn = 24);
    else cylinder(r = 1, h = 1, $fn = 24);
}
