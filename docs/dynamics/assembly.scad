// How a clamp is put together: a cover comes down, bolts go in, nuts are screwed on from below.
function step(from, to) = let (s = max(0, min(1, ($t - from) / (to - from)))) s * s * (3 - 2 * s);

cover = 34 * (1 - step(0, 0.3));
bolt = 40 * (1 - step(0.35, 0.6));
nut = 24 * (1 - step(0.65, 0.95));
places = [[-18, 0], [18, 0]];

module holes() for (p = places) translate(p) translate([0, 0, -10]) cylinder(h = 50, r = 3.2, $fn = 32);
module base() difference() {
  translate([-28, -12, 0]) cube([56, 24, 8]);
  holes();
  translate([0, 13, 8]) rotate([90, 0, 0]) cylinder(h = 26, r = 6, $fn = 48);
}
module cover() difference() {
  translate([-28, -12, 8.5]) cube([56, 24, 8]);
  holes();
  translate([0, 13, 8]) rotate([90, 0, 0]) cylinder(h = 26, r = 6, $fn = 48);
}
module bolt() {
  translate([0, 0, 16.5]) cylinder(h = 4, r = 5.5, $fn = 6);
  translate([0, 0, -8]) cylinder(h = 25, r = 3, $fn = 32);
}
module nut() difference() {
  translate([0, 0, -5]) cylinder(h = 5, r = 5.5, $fn = 6);
  translate([0, 0, -6]) cylinder(h = 7, r = 3.05, $fn = 32);
}

color("#4070a0") base();
color("#6a98c8") translate([0, 0, cover]) cover();
module bolts() for (p = places) translate([p.x, p.y, bolt]) bolt();
module nuts() for (p = places) translate([p.x, p.y, -nut]) rotate(-45 * nut) nut();
color("#b0b0a8") bolts();
color("#c89040") nuts();
