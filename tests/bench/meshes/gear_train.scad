// Six meshing spur gears with hubs, spokes, keyways and shafts between two plates. 158 leaves.
module_size = 2;
teeth = [24, 12, 30, 16, 36, 14];

function involute(radius, angle) = radius * [cos(angle) + angle * PI / 180 * sin(angle),
                                             sin(angle) - angle * PI / 180 * cos(angle)];

module tooth(n) {
    pitch = module_size * n / 2;
    base = pitch * cos(20);
    tip = pitch + module_size;
    last = sqrt(pow(tip / base, 2) - 1) * 180 / PI;
    at_pitch = sqrt(pow(pitch / base, 2) - 1) * 180 / PI;
    flank = [for (i = [0:6]) involute(base, last * i / 6)];
    middle = atan2(involute(base, at_pitch)[1], involute(base, at_pitch)[0]) + 89 / n;
    turned = [for (p = flank) [p[0] * cos(middle) + p[1] * sin(middle), p[1] * cos(middle) - p[0] * sin(middle)]];
    polygon(concat([[0, turned[0][1]]], turned, [for (i = [6:-1:0]) [turned[i][0], -turned[i][1]]],
                   [[0, -turned[0][1]]]));
}

module gear(n, height) {
    pitch = module_size * n / 2;
    difference() {
        union() {
            linear_extrude(height) {
                circle(pitch - 1.25 * module_size, $fn = 2 * n);
                for (i = [0:n - 1]) rotate(i * 360 / n) tooth(n);
            }
            cylinder(h = height + 3, r = 5, $fn = 32);
        }
        translate([0, 0, -1]) cylinder(h = height + 9, r = 3, $fn = 32);
        translate([2, -1, -1]) cube([2, 2, height + 9]);
        if (n > 20) for (i = [0:5]) rotate(60 * i) translate([pitch * 0.55, 0, -1])
            cylinder(h = height + 2, r = pitch * 0.16, $fn = 24);
    }
}

function place(i) = i == 0 ? 0 : place(i - 1) + module_size * (teeth[i - 1] + teeth[i]) / 2;
function phase(i) = i == 0 ? 0 : 180 - 180 / teeth[i] + (180 - phase(i - 1)) * teeth[i - 1] / teeth[i];

for (i = [0:len(teeth) - 1]) translate([place(i), 0, 3 + (i % 2) * 0.5]) {
    rotate(phase(i)) gear(teeth[i], 8);
    color("silver") translate([0, 0, -7]) cylinder(h = 30, r = 2.9, $fn = 32);
}
color("steelblue") for (z = [-6, 18]) difference() {
    translate([-30, -24, z]) cube([place(5) + 60, 48, 4]);
    for (i = [0:len(teeth) - 1]) translate([place(i), 0, z - 1]) cylinder(h = 6, r = 3, $fn = 32);
    for (x = [-24:24:place(5) + 24], y = [-19, 19]) translate([x, y, z - 1]) cylinder(h = 6, r = 1.6, $fn = 20);
}
