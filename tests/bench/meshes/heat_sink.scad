// A pin-fin heat sink: tapered pins on a base that is bored and pocketed. 413 leaves.
columns = 24;
rows = 16;
pitch = 4;
difference() {
    union() {
        translate([-pitch / 2, -pitch / 2, 0]) cube([columns * pitch, rows * pitch, 5]);
        for (x = [0:columns - 1], y = [0:rows - 1])
            translate([x * pitch, y * pitch, 4]) cylinder(h = 18, r1 = 1.3, r2 = 0.8, $fn = 12);
    }
    for (x = [3:6:columns], y = [3:6:rows])
        translate([(x + 0.5) * pitch, (y + 0.5) * pitch, -1]) cylinder(h = 40, d = 2.2, $fn = 20);
    translate([28, 18, -1]) cube([34, 24, 2.5]);
    for (x = [-1, columns * pitch - 3]) translate([x, 28, -1]) cylinder(h = 10, d = 1.8, $fn = 16);
    for (y = [4:8:rows * pitch - 8]) translate([-10, y, 2.5]) rotate([0, 90, 0]) cylinder(h = 14, d = 1, $fn = 10);
}
