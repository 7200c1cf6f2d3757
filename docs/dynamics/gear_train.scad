// Three gears in a row; the first turns once while $t runs from 0 to 1.
use <../../models/gears.scad>

size = 2;  // Module: pitch circles are teeth * size across.
teeth = [16, 32, 24];
first = 360 * $t;
second = meshing(teeth[1]) - first * teeth[0] / teeth[1];
third = meshing(teeth[2]) - second * teeth[1] / teeth[2];
x = [0, (teeth[0] + teeth[1]) * size / 2, (teeth[0] + 2 * teeth[1] + teeth[2]) * size / 2];

module driver() gear(teeth[0], size, 12, 6, $fn = 48);
module idler() gear(teeth[1], size, 10, 8, holes = 6, $fn = 48);
module driven() gear(teeth[2], size, 12, 7, holes = 5, $fn = 48);
module plate() {
  translate([-20, -38, -14]) cube([x[2] + 48, 76, 5]);
  for (i = [0:2]) translate([x[i], 0, -10]) cylinder(h = 20, r = [5.8, 7.8, 6.8][i], $fn = 48);
}

color("#b05030") rotate(first) driver();
color("#4070a0") translate([x[1], 0, 0]) rotate(second) idler();
color("#508050") translate([x[2], 0, 0]) rotate(third) driven();
color("#b0b0a8") plate();
