// A bolt with a helical thread and its nut: twisted extrusions cut to length, chamfered. 21 leaves.
diameter = 12;
pitch = 2;

module thread(length, grow) {
    linear_extrude(length, twist = -360 * length / pitch, slices = 12 * length / pitch, convexity = 10)
        translate([pitch / 4, 0]) circle(diameter / 2 - pitch / 4 + grow, $fn = 48);
}

module bolt() {
    intersection() {
        union() {
            thread(40, 0);
            translate([0, 0, 32]) cylinder(h = 8, r = diameter / 2 + 1, $fn = 48);
        }
        union() {
            cylinder(h = 1, r1 = diameter / 2 - 1, r2 = diameter / 2, $fn = 48);
            translate([0, 0, 1]) cylinder(h = 39, r = diameter / 2 + 1, $fn = 48);
        }
    }
    translate([0, 0, 40]) difference() {
        intersection() {
            cylinder(h = 8, d = 22, $fn = 6);
            cylinder(h = 8, r1 = 14, r2 = 10, $fn = 60);
        }
        translate([0, 0, 4]) cylinder(h = 9, d = 9, $fn = 6);
    }
}

module nut() {
    difference() {
        intersection() {
            cylinder(h = 9, d = 22, $fn = 6);
            cylinder(h = 9, r1 = 10, r2 = 15, $fn = 60);
            cylinder(h = 9, r1 = 15, r2 = 10, $fn = 60);
        }
        translate([0, 0, -1]) thread(11, 0.2);
        translate([0, 0, -0.01]) cylinder(h = 1, r1 = 6.7, r2 = 5.7, $fn = 48);
    }
}

bolt();
translate([30, 0, 0]) nut();
translate([30, 30, 0]) difference() {
    cylinder(h = 2, d = 24, $fn = 60);
    translate([0, 0, -1]) cylinder(h = 4, d = 13, $fn = 60);
}
