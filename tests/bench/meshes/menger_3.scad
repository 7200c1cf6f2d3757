// A Menger sponge of the third order: a cube minus bars through it, flush with each other. 220 leaves.
size = 27;
order = 3;

module bars(size, order) {
    if (order > 0) {
        third = size / 3;
        translate([third, third, -1]) cube([third, third, 29]);
        for (x = [0:2], y = [0:2]) if (x != 1 || y != 1) translate([x * third, y * third, 0]) bars(third, order - 1);
    }
}

difference() {
    cube(size);
    bars(size, order);
    translate([0, size, 0]) rotate([90, 0, 0]) bars(size, order);
    translate([0, 0, size]) rotate([0, 90, 0]) bars(size, order);
}
