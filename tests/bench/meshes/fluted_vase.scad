// A vase of revolution with twisted flutes, pierced by spheres, with a beaded foot. 118 leaves.
function profile(t) = [14 + 6 * sin(3.2 * t) + 0.05 * t, 0.8 * t];
outside = [for (i = [0:90]) profile(i)];

difference() {
    rotate_extrude($fn = 144) polygon(concat([[0, 0]], outside, [[0, outside[90][1]]]));
    translate([0, 0, 3]) rotate_extrude($fn = 144)
        polygon(concat([[0, 0]], [for (p = outside) p - [2.2, 0]], [[0, outside[90][1]]]));
    for (i = [0:17]) rotate(20 * i) linear_extrude(80, twist = 90, slices = 60)
        translate([25.2, 0]) circle(3.4, $fn = 12);
    for (row = [0:4], i = [0:11]) rotate(30 * i + 15 * (row % 2)) translate([14, 0, 16 + 11 * row])
        rotate([0, 90, 0]) cylinder(h = 20, d = 4, $fn = 16);
}
for (i = [0:35]) rotate(10 * i) translate([14.5, 0, 1.2]) sphere(1.6, $fn = 16);
