// Everything flush: cuts that end in the surface, inlays, blocks that touch, equal solids
// taken from each other. Each case stands on its own tile; nothing here may flicker, show a
// skin over a hole or a wall between two blocks.
pitch = 14;

module tile(column, row) {
  translate([pitch * column, pitch * row, 0]) children();
}

module block(size = 10, h = 10) {
  translate([-size / 2, -size / 2, 0]) cube([size, size, h]);
}

// 1  A cut that is open at the top and at the bottom: flush with both faces.
tile(0, 0) difference() {
  block();
  block(6, 10);
}

// 2  A step whose faces lie in four faces of the block.
tile(1, 0) difference() {
  block();
  translate([0, -5, 5]) cube([5, 10, 5]);
}

// 3  An inlay that fills its recess exactly.
tile(2, 0) {
  difference() {
    color("SlateGray") block();
    translate([-3, -3, 7]) cube([6, 6, 3]);
  }
  color("Orange") translate([-3, -3, 7]) cube([6, 6, 3]);
}

// 4  Eight cubes that touch are one cube.
tile(3, 0) for (x = [-5, 0], y = [-5, 0], z = [0, 5]) translate([x, y, z]) cube(5);

// 5  A solid minus itself leaves nothing but the ball beside it.
tile(0, 1) {
  difference() {
    block();
    block();
  }
  translate([0, 0, 5]) sphere(4, $fn = 32);
}

// 6  The same cut from all six sides, all of one depth: a cross-shaped core remains.
tile(1, 1) difference() {
  block();
  for (x = [-5, 2], y = [-5, 2]) translate([x, y, 0]) cube([3, 3, 10]);
  for (x = [-5, 2], z = [0, 7]) translate([x, -5, z]) cube([3, 10, 3]);
  for (y = [-5, 2], z = [0, 7]) translate([-5, y, z]) cube([10, 3, 3]);
}

// 7  Turned by an angle that no number holds exactly, and still flush.
tile(2, 1) translate([0, 0, 5]) rotate([31, 17, 43]) {
  difference() {
    cube(8, center = true);
    cube([4, 4, 8], center = true);
    cube([8, 2, 2], center = true);
  }
  cube([2, 2, 8], center = true);
}

// 8  An intersection whose operands share four faces.
tile(3, 1) intersection() {
  block();
  translate([-5, -5, 3]) cube([10, 10, 7]);
  union() {
    translate([-5, -5, 0]) cube([10, 5, 10]);
    translate([-5, -5, 0]) cube([5, 10, 10]);
  }
}

// 9  Cylinders end to end, bored through and capped flush.
tile(0, 2) difference() {
  for (z = [0:4]) translate([0, 0, 2 * z]) cylinder(h = 2, r = 5, $fn = 36);
  cylinder(h = 10, r = 3, $fn = 36);
  for (a = [0:60:300]) rotate(a) translate([0, -1, 8]) cube([5, 2, 2]);
}

// 10  A lid of no thickness vanishes; one that touches from outside cuts nothing.
tile(1, 2) difference() {
  block();
  translate([-4, -4, 2]) cube([8, 8, 8]);
  translate([-5, -5, 10]) cube([10, 10, 4]);
  translate([-5, -5, 5]) cube([10, 10, 0]);
}

// 11  Two wedges meet in a slanted plane.
tile(2, 2) {
  points = [[-5, -5, 0], [5, -5, 0], [5, 5, 0], [-5, 5, 0], [-5, -5, 10], [-5, 5, 10]];
  faces = [[0, 1, 2, 3], [4, 1, 0], [5, 3, 2], [4, 5, 2, 1], [0, 3, 5, 4]];
  polyhedron(points, faces);
  translate([0, 0, 10]) rotate([0, 180, 0]) polyhedron(points, faces);
}

// 12  Differences within differences, all of them flush.
tile(3, 2) difference() {
  block();
  difference() {
    block(8, 10);
    difference() {
      block(6, 10);
      block(4, 10);
    }
  }
}
