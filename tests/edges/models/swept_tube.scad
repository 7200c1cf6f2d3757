// A square tube along a curve, as a polyhedron.
n = 60;
function at(t) = [30 * cos(t), 30 * sin(t), 10 * sin(2 * t)];
function unit(v) = v / norm(v);
section = [[-4, -4], [4, -4], [4, 4], [-4, 4]];
points = [for (k = [0:n]) let (t = 270 * k / n, d = unit(at(t + 1) - at(t - 1)), u = unit(cross([0, 0, 1], d)), v = cross(d, u))
    for (p = section) at(t) + p.x * u + p.y * v];
faces = concat([[0, 1, 2, 3]], [[for (j = [3:-1:0]) 4 * n + j]],
    [for (k = [0:n - 1], j = [0:3]) let (a = 4 * k + j, b = 4 * k + (j + 1) % 4) each [[a, a + 4, b], [b, a + 4, b + 4]]]);
polyhedron(points, faces);
