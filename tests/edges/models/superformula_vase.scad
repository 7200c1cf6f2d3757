// Rounded lobes with cusps between them, swept up as a polyhedron.
function super(a, m, n1, n2, n3) = (abs(cos(m * a / 4)) ^ n2 + abs(sin(m * a / 4)) ^ n3) ^ (-1 / n1);
n = 120;
rings = 40;
points = [for (k = [0:rings]) let (z = k / rings, s = 20 + 8 * sin(200 * z))
    for (i = [0:n - 1]) let (a = 360 * i / n, r = s * super(a, 6, 3, 6, 6)) [r * cos(a + 40 * z), r * sin(a + 40 * z), 60 * z]];
faces = [[for (i = [0:n - 1]) i], [for (i = [n - 1:-1:0]) rings * n + i],
    for (k = [0:rings - 1], i = [0:n - 1]) let (a = k * n + i, b = k * n + (i + 1) % n)
        each [[a, a + n, b], [b, a + n, b + n]]];
polyhedron(points, faces);
