// A handle swept as a chain of hulls along a knot, on a bored base. 187 leaves.
steps = 180;
function knot(t) = 9 * [sin(t) + 2 * sin(2 * t), cos(t) - 2 * cos(2 * t), -sin(3 * t)];

module bead(t) {
    translate(knot(t)) rotate([t, 2 * t, 0]) sphere(2.6 + 0.8 * cos(9 * t), $fn = 14);
}

for (i = [0:steps - 1]) hull() {
    bead(i * 360 / steps);
    bead((i + 1) * 360 / steps);
}
difference() {
    hull() for (x = [-20, 20], y = [-20, 20]) translate([x, y, -16]) cylinder(h = 6, r = 8, $fn = 32);
    for (x = [-20, 20], y = [-20, 20]) translate([x, y, -17]) cylinder(h = 8, r = 3, $fn = 24);
    translate([0, 0, -17]) cylinder(h = 9, r = 14, $fn = 48);
}
