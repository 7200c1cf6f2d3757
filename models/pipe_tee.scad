// A flanged pipe tee: three bores meet inside, each flange has its ring of bolt holes,
// a raised sealing face and a reinforcing collar.
$fn = 64;

bore = 25;        // radius of the run
branch_bore = 19; // radius of the branch
wall = 5;
run = 150;        // from flange to flange
branch = 85;      // from the axis of the run to the flange of the branch

flange = 12;      // thickness
rim = 24;         // how far a flange reaches beyond the pipe
bolts = 8;
bolt_hole = 4.5;  // radius
face = 1.5;       // height of the sealing face

// What a pipe of the given radius adds, from the origin up to length.
module pipe(radius, length) {
  outer = radius + wall;
  cylinder(h = length, r = outer);
  translate([0, 0, length - flange - face]) cylinder(h = flange, r = outer + rim);
  translate([0, 0, length - face]) cylinder(h = face, r = outer + 0.35 * rim);
  translate([0, 0, length - flange - face - 10]) cylinder(h = 10, r1 = outer, r2 = outer + 0.3 * rim);
}

// What it takes away.
module pipe_bore(radius, length) {
  circle_of_bolts = radius + wall + 0.62 * rim;
  translate([0, 0, -1]) cylinder(h = length + 2, r = radius);
  for (i = [0:bolts - 1])
    rotate((i + 0.5) * 360 / bolts) translate([circle_of_bolts, 0, length - flange - face - 1])
      cylinder(h = flange + face + 2, r = bolt_hole, $fn = 24);
}

module each_end() {
  for (end = [-90, 90]) rotate([0, end, 0]) children(0);
  children(1);
}

color("SlateGray")
difference() {
  union() {
    each_end() { pipe(bore, run / 2); pipe(branch_bore, branch); }
    sphere(r = bore + wall + 3);
  }
  each_end() { pipe_bore(bore, run / 2); pipe_bore(branch_bore, branch); }
}
