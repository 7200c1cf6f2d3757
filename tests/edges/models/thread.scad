// A screw thread as one polyhedron about a rod.
steps = 48;
turns = 5;
pitch = 4;
profile = [[9, -1.6], [12, -0.5], [12, 0.5], [9, 1.6]];
m = len(profile);
n = steps * turns;
points = [for (k = [0:n]) let (a = 360 * k / steps, z = pitch * k / steps)
    for (p = profile) [p.x * cos(a), p.x * sin(a), p.y + z]];
faces = concat([[for (j = [0:m - 1]) j]], [[for (j = [m - 1:-1:0]) n * m + j]],
    [for (k = [0:n - 1], j = [0:m - 1]) let (a = k * m + j, b = k * m + (j + 1) % m) each [[a, a + m, b + m], [a, b + m, b]]]);
union() {
    polyhedron(points, faces);
    translate([0, 0, -4]) cylinder(r = 10, h = 28, $fn = 48);
    translate([0, 0, 24]) cylinder(r = 16, h = 8, $fn = 6);
}
