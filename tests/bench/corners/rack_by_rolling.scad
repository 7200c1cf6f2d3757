// A cutter rolls along a bar, in 21 steps a tooth.
teeth = 100;
steps = 10;
difference() {
    cube([teeth * PI, 3, 4]);
    for (i = [0 : teeth - 1], s = [-steps : steps]) translate([i * PI + s * 0.05 * PI, 3, -1]) rotate(s * 4)
        linear_extrude(6) polygon([[-0.9, 1.5], [-0.3, -2.2], [0.3, -2.2], [0.9, 1.5]]);
}
