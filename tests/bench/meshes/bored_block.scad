// A manifold block: crossing oil ways, ports with spot faces, and balls of clearance. 152 leaves.
difference() {
    cube([90, 60, 40]);
    for (x = [10:14:80]) translate([x, -1, 12]) rotate([-90, 0, 0]) cylinder(h = 62, d = 6, $fn = 32);
    for (y = [10:10:50]) translate([-1, y, 28]) rotate([0, 90, 0]) cylinder(h = 92, d = 5, $fn = 32);
    for (x = [10:14:80], y = [10:10:50]) {
        translate([x, y, 12]) cylinder(h = 40, d = 4, $fn = 24);
        translate([x, y, 38]) cylinder(h = 9, d = 8, $fn = 24);
        translate([x, y, 12]) sphere(d = 8, $fn = 24);
        translate([x, y, 28]) sphere(d = 7, $fn = 24);
    }
    for (x = [0, 90], y = [0, 60]) translate([x, y, -1]) cylinder(h = 42, r = 3, $fn = 32);
}
