// A two-stage gearbox: the casing hides three shafts, four gears and six ball bearings,
// all of which a blueprint shows. Drawn with the shafts along z, then stood on its feet.
use <gears.scad>

$fn = 48;

size = 2;            // module of all gears
first = [15, 41];    // teeth of pinion and wheel
second = [14, 42];
distance = [(first[0] + first[1]) * size / 2, (second[0] + second[1]) * size / 2];

inside = 62;         // between the side walls
wall = 6;
floor_height = 54;   // from the shafts down to the floor of the cavity, and up to its ceiling
boss = 5;            // how far the bearing seats stand out

shaft_at = [0, distance[0], distance[0] + distance[1]];
shaft_radius = [8, 9, 11];
bearing_radius = [18, 19, 23];
bearing_width = 9;
bearing_at = inside / 2 + wall + boss - bearing_width / 2 - 1.5;

left = -second[0] * size / 2 - 22;
right = shaft_at[2] + second[1] * size / 2 + 10;

// A block between two corners of the plane z = 0, its edges along z rounded.
module rounded_block(low, high, height, radius) {
  span = high - low;
  translate([low.x, low.y + radius, -height / 2]) cube([span.x, span.y - 2 * radius, height]);
  translate([low.x + radius, low.y, -height / 2]) cube([span.x - 2 * radius, span.y, height]);
  for (x = [low.x + radius, high.x - radius], y = [low.y + radius, high.y - radius])
    translate([x, y, 0]) cylinder(h = height, r = radius, center = true);
}

module shell(grow, height) {
  rounded_block([left - grow, -floor_height - grow], [right + grow, floor_height + grow], height, 18 + grow);
}

module parting_flange(height, grow) {
  translate([left - wall - grow, -height / 2, -inside / 2 - wall - grow])
    cube([right - left + 2 * (wall + grow), height, inside + 2 * (wall + grow)]);
}

module parting_bolts(radius, length) {
  for (x = [left - wall - 6, right + wall + 6], z = [-0.38, 0.38])
    translate([x, 0, z * inside]) rotate([90, 0, 0]) cylinder(h = length, r = radius, center = true, $fn = 24);
}

module foot(x) {
  translate([x - 14, -floor_height - wall - 4, -inside / 2 - wall - 18]) cube([28, 9, inside + 2 * wall + 36]);
}

module foot_holes(x) {
  for (z = [-1, 1])
    translate([x, -floor_height - wall, z * (inside / 2 + wall + 10)]) rotate([90, 0, 0])
      cylinder(h = 20, r = 4.5, center = true, $fn = 24);
}

module each_side() {
  for (side = [-1, 1]) mirror([0, 0, side < 0 ? 1 : 0]) children();
}

module casing() {
  difference() {
    union() {
      shell(wall, inside + 2 * wall);
      parting_flange(12, 12);
      for (x = [left + 20, right - 20]) foot(x);
      each_side() for (i = [0:2])
        translate([shaft_at[i], 0, inside / 2])
          cylinder(h = wall + boss, r1 = bearing_radius[i] + 9, r2 = bearing_radius[i] + 6);
      translate([right - 60, floor_height + wall, 0]) rotate([-90, 0, 0]) cylinder(h = 5, r = 24);
    }
    shell(0, inside);
    parting_flange(1, 20);
    parting_bolts(3.5, 40);
    for (x = [left + 20, right - 20]) foot_holes(x);
    each_side() for (i = [0:2])
      translate([shaft_at[i], 0, inside / 2 - 1]) cylinder(h = wall + boss + 2, r = bearing_radius[i]);
    translate([right - 60, floor_height - 1, 0]) rotate([-90, 0, 0]) cylinder(h = wall + 7, r = 17);
  }
}

module gasket() {
  difference() {
    parting_flange(1, 10.5);
    shell(0, inside);
    each_side() for (i = [0:2])
      translate([shaft_at[i], 0, inside / 2 - 1]) cylinder(h = wall + 20, r = bearing_radius[i]);
    parting_bolts(3.5, 40);
  }
}

// A shaft from one side of the box to the other, with a keyed end that leaves it at the given side.
module shaft(i, side) {
  reach = side == 0 ? 0 : 34;
  half = inside / 2 + wall + boss;
  difference() {
    union() {
      cylinder(h = 2 * half - 4, r = shaft_radius[i], center = true);
      cylinder(h = 2 * (bearing_at - bearing_width / 2), r = shaft_radius[i] + 2, center = true);
      if (side != 0) mirror([0, 0, side < 0 ? 1 : 0]) cylinder(h = half + reach, r = shaft_radius[i] - 1);
    }
    if (side != 0) mirror([0, 0, side < 0 ? 1 : 0])
      translate([shaft_radius[i] - 4, -2, half + 8]) cube([4, 4, reach]);
  }
}

module works() {
  stage = [-inside / 4, inside / 4];
  for (i = [0:2]) {
    color("Silver") translate([shaft_at[i], 0, 0]) shaft(i, i == 0 ? 1 : i == 1 ? 0 : -1);
    each_side() translate([shaft_at[i], 0, bearing_at])
      bearing(bearing_radius[i], shaft_radius[i], bearing_width);
  }
  color("Goldenrod") translate([shaft_at[0], 0, stage[0]]) gear(first[0], size, 20, shaft_radius[0] + 2);
  color("Peru") translate([shaft_at[1], 0, stage[0]]) rotate(meshing(first[1]))
    gear(first[1], size, 18, shaft_radius[1] + 2, holes = 6);
  color("Goldenrod") translate([shaft_at[1], 0, stage[1]]) gear(second[0], size, 24, shaft_radius[1] + 2);
  color("Peru") translate([shaft_at[2], 0, stage[1]]) rotate(meshing(second[1]))
    gear(second[1], size, 22, shaft_radius[2] + 2, holes = 6);
}

module bolts() {
  color("DimGray") {
    parting_bolts(3.4, 22);
    for (side = [-1, 1]) translate([0, side * 8.5, 0])
      for (x = [left - wall - 6, right + wall + 6], z = [-0.38, 0.38])
        translate([x, 0, z * inside]) rotate([90, 0, 0]) cylinder(h = 5, r = 5.6, center = true, $fn = 6);
  }
}

rotate([90, 0, 0]) {
  color("SteelBlue") casing();
  color("Tomato") gasket();
  works();
  bolts();
}
