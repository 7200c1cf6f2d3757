// A name plate: raised and engraved lines of text, a rounded rim, screw holes. 34 leaves.
lines = ["IMAGE-BASED", "constructive solid geometry", "0123456789 & % @ ? {}", "Goldfeather 1986"];

module rounded(size, radius) {
    offset(radius, $fn = 48) offset(-radius) square(size, center = true);
}

difference() {
    linear_extrude(5) rounded([150, 80], 8);
    translate([0, 0, 3]) linear_extrude(3) rounded([142, 72], 5);
    for (x = [-66, 66], y = [-31, 31]) translate([x, y, -1]) {
        cylinder(h = 9, d = 3.4, $fn = 32);
        translate([0, 0, 2]) cylinder(h = 3, d1 = 3.4, d2 = 8, $fn = 32);
    }
    for (i = [1:len(lines) - 1]) translate([0, 20 - 16 * i, 2]) linear_extrude(4)
        text(lines[i], size = 8, halign = "center", valign = "center", font = "Liberation Sans");
}
translate([0, 21, 2]) linear_extrude(3)
    text(lines[0], size = 13, halign = "center", valign = "center", font = "Liberation Sans:style=Bold");
for (i = [0:11]) rotate(30 * i) translate([0, 0, 4]) if (i % 3 != 0)
    translate([48 * cos(10 * i), 0, 0]) cylinder(h = 2, r1 = 2, r2 = 1, $fn = 24);
