// Shallow chamfers, tangent arcs and a countersunk hole.
difference() {
    hull() {
        translate([-20, -12, 0]) cube([40, 24, 6]);
        translate([-14, -6, 0]) cube([28, 12, 7]);
    }
    translate([0, 0, -1]) cylinder(r = 3, h = 10, $fn = 40);
    translate([0, 0, 5]) cylinder(r1 = 3, r2 = 5, h = 2.01, $fn = 40);
}
translate([-36, 0, 0]) linear_extrude(6) offset(r = 3, $fn = 32) square([10, 14], center = true);
