// A sheet with hexagonal perforation, a frame and countersunk corners. 1,163 leaves.
columns = 41;
rows = 28;
pitch = 5;
width = columns * pitch + 10;
height = rows * pitch * sqrt(3) / 2 + 10;
difference() {
    union() {
        cube([width, height, 1.5]);
        difference() {
            cube([width, height, 6]);
            translate([3, 3, -1]) cube([width - 6, height - 6, 9]);
        }
        for (x = [5, width - 5], y = [5, height - 5]) translate([x, y, 0]) cylinder(h = 6, r = 5, $fn = 32);
    }
    for (row = [0:rows - 1], column = [0:columns - 1])
        translate([(column + (row % 2) / 2) * pitch + 7, row * pitch * sqrt(3) / 2 + 8, -1])
            cylinder(h = 3, d = 3.6, $fn = 6);
    for (x = [5, width - 5], y = [5, height - 5]) translate([x, y, -1]) {
        cylinder(h = 9, d = 3.2, $fn = 24);
        translate([0, 0, 5]) cylinder(h = 2.1, d1 = 3, d2 = 7, $fn = 24);
    }
}
