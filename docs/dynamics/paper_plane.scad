// A paper plane that flies a curve, while $t runs from 0 to 1.
a = 110 * $t;
module wing() polyhedron(
  [[12, 0, 0], [-10, 0, 0.2], [-10, 9, 2.2], [12, 0, 0.3], [-10, 0, 0.5], [-10, 9, 2.5]],
  [[0, 1, 2], [3, 5, 4], [0, 3, 4, 1], [1, 4, 5, 2], [0, 2, 5, 3]]);
module paper_plane() color("#f4f0e4") {
  wing();
  mirror([0, 1, 0]) wing();
  rotate([90, 0, 0]) translate([0, 0, -0.2]) linear_extrude(0.4) polygon([[12, 0], [-10, 0.2], [-8, -4]]);
}
translate([75 * sin(a), 75 * (1 - cos(a)), 12 * sin(3 * a)]) rotate([0, 0, a]) rotate([-25, -25 * cos(3 * a), 0])
  paper_plane();
