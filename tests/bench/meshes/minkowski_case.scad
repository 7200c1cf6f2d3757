// A case for electronics, rounded by Minkowski sums: vents, posts, sockets. 97 leaves.
inner = [80, 54, 22];
wall = 2;

module rounded_box(size, radius) {
    minkowski() {
        translate([radius, radius, radius]) cube(size - 2 * radius * [1, 1, 1]);
        sphere(radius, $fn = 24);
    }
}

difference() {
    translate(-wall * [1, 1, 1]) rounded_box(inner + 2 * wall * [1, 1, 1], 5);
    rounded_box(inner, 3);
    translate([-5, -5, inner[2] - 5]) cube([inner[0] + 10, inner[1] + 10, 20]);
    for (x = [12:4:68], y = [12, 24, 36]) hull() {
        translate([x, y, -5]) cylinder(h = 9, d = 1.8, $fn = 16);
        translate([x, y + 7, -5]) cylinder(h = 9, d = 1.8, $fn = 16);
    }
    translate([-5, 14, 6]) rotate([90, 0, 90]) linear_extrude(9) offset(1, $fn = 16) square([9, 4]);
    translate([-5, 34, 8]) rotate([0, 90, 0]) cylinder(h = 9, d = 6.5, $fn = 32);
    for (y = [10:6:44]) translate([inner[0] - 2, y, 4]) cube([9, 3, 9]);
}
for (x = [8, inner[0] - 8], y = [6, inner[1] - 6]) translate([x, y, -1]) difference() {
    union() {
        cylinder(h = 9, d = 7, $fn = 32);
        cylinder(h = 4, d1 = 10, d2 = 7, $fn = 32);
    }
    translate([0, 0, 2]) cylinder(h = 9, d = 2.6, $fn = 20);
}
