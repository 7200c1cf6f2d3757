// Many leaves, for docs/PERFORMANCE.md: about n³ of them, which
//   "apart"      do not meet,
//   "touching"   share a face with each neighbour,
//   "pairs"      overlap with one other,
//   "drilled"    have a hole each,
//   "bar"        are cut by common bars,
//   "tetrahedra" are the shells of one leaf, at random.
n = 100;
kind = "apart";

module grid(d) for (x = [0:n - 1], y = [0:n - 1], z = [0:n - 1]) translate(d * [x, y, z]) children();

if (kind == "apart") grid(2) cube(1);
if (kind == "touching") grid(1) cube(1);
if (kind == "pairs") grid(3) for (d = [0, .5]) translate([d, d, d]) cube(1);
if (kind == "drilled") grid(2) difference() { cube(1); translate([.5, .5, -1]) cylinder(h = 3, r = .25, $fn = 8); }
if (kind == "bar") difference() {
    grid(2) cube(1);
    for (x = [0:n - 1], y = [0:n - 1]) translate([2 * x + .25, 2 * y + .25, -1]) cube([.5, .5, 2 * n]);
}
if (kind == "tetrahedra") {
    count = n * n * n;
    side = 3 * n;
    at = rands(0, side, 3 * count, 1);
    polyhedron([for (i = [0:count - 1]) let(p = [at[3 * i], at[3 * i + 1], at[3 * i + 2]])
                    each [p, p + [1, .1, 0], p + [0, 1, .2], p + [.1, 0, 1]]],
               [for (i = [0:count - 1]) each [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]] + 4 * i * [[1, 1, 1], [1, 1, 1], [1, 1, 1], [1, 1, 1]]]);
}
