// 200 slots across, 20 along.
difference() {
    cube([200, 20, 5]);
    for (i = [0 : 199]) translate([i + 0.25, -1, 2]) cube([0.5, 30, 5]);
    for (i = [0 : 19]) translate([-1, i + 0.25, 1.5]) cube([300, 0.5, 9]);
}
