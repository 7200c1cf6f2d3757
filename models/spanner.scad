// A combination spanner: an open jaw at one end, a twelve-point ring at the other.
// Jaw and ring are tilted against the handle, whose two recesses leave a thin web.
$fn = 64;

size = 13;           // width across the flats of the nut
length = 105;        // between the centres of the two heads
jaw_angle = 15;      // of the open jaw in the plane of the handle
ring_angle = 10;     // of the ring out of that plane
clearance = 0.2;
thickness = 0.55 * size;
handle = [length, 0.85 * size, 0.42 * size];
web = 0.16 * size;   // what is left of the handle between its recesses

across = size + clearance;

// A slot with round ends, standing on the plane z = 0 and lying along x.
module slot(length, width, height) {
  translate([-length / 2, -width / 2, 0]) cube([length, width, height]);
  for (end = [-1, 1])
    translate([end * length / 2, 0, 0]) cylinder(h = height, d = width);
}

// A disc whose rims are broken by the ball it is cut from.
module head(diameter, height) {
  intersection() {
    cylinder(h = height, d = diameter, center = true);
    sphere(d = 1.035 * sqrt(diameter * diameter + 0.55 * height * height), $fn = 96);
  }
}

// Two hexagons, turned by 30 degrees against each other: room for a nut in twelve positions.
module twelve_points(flats, height) {
  for (turn = [0, 30])
    rotate(turn)
      cylinder(h = height, d = flats / cos(30), center = true, $fn = 6);
}

module jaw_opening() {
  rotate(jaw_angle) {
    cylinder(h = 3 * thickness, d = across / cos(30), center = true, $fn = 6);
    translate([-2 * size, -across / 2, -2 * thickness])
      cube([2 * size, across, 4 * thickness]);
  }
}

module recesses() {
  depth = (handle.z - web) / 2;
  for (side = [-1, 1])
    translate([length / 2, 0, side * (web / 2 + depth / 2 + 0.5) - depth / 2 - 0.5])
      slot(length - 3.6 * size, 0.48 * handle.y, depth + 1);
}

color("Silver")
difference() {
  union() {
    head(2.25 * size, thickness);
    translate([length, 0, 0]) rotate([0, ring_angle, 0]) head(1.62 * size, 0.75 * size);
    translate([0, -handle.y / 2, -handle.z / 2]) cube(handle);
  }
  jaw_opening();
  translate([length, 0, 0]) rotate([0, ring_angle, 0]) twelve_points(across, 3 * thickness);
  recesses();
}
