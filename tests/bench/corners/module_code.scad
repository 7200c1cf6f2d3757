// A plate of square modules, as libraries for two-dimensional codes make them.
n = 200;
size = 1 / 3;
dark = rands(0, 1, n * n, 42);
translate([0, 0, -0.5]) cube([n * size, n * size, 0.5]);
for (x = [0 : n - 1]) translate([x * size, 0, 0])
    for (y = [0 : n - 1]) if (dark[x + n * y] > 0.5) translate([0, y * size, 0]) linear_extrude(1) square(size);
