// Spur gears and ball bearings, for the models that use them. Axes are z, and the parts
// are centred on z = 0. On its own this file shows one meshing pair.

pressure_angle = 20;

function involute(angle) = tan(angle) - angle * PI / 180;

// Half the angle that a tooth takes at the given radius, in degrees.
function half_tooth(teeth, pitch, base, radius) =
  86 / teeth + 180 / PI * (involute(pressure_angle) - involute(acos(min(1, base / radius))));

// The outline of a gear, counter-clockwise, with the middle of its first tooth on the x axis.
function gear_outline(teeth, size) =
  let (pitch = teeth * size / 2, base = pitch * cos(pressure_angle),
       root = pitch - 1.2 * size, tip = pitch + size,
       radii = [root, max(root, base) + 0.1 * size, pitch, tip],
       halves = [for (r = radii) half_tooth(teeth, pitch, base, r)])
  [for (tooth = [0:teeth - 1], i = [0:7])
     let (flank = i < 4 ? i : 7 - i, side = i < 4 ? -1 : 1,
          angle = tooth * 360 / teeth + side * halves[flank])
     radii[flank] * [cos(angle), sin(angle)]];

// A prism over an outline that can be seen whole from the origin.
module star_prism(outline, height) {
  n = len(outline);
  points = concat(
    [for (p = outline) [p.x, p.y, -height / 2]], [for (p = outline) [p.x, p.y, height / 2]],
    [[0, 0, -height / 2], [0, 0, height / 2]]);
  faces = [for (i = [0:n - 1]) let (next = (i + 1) % n)
    each [[i, next, 2 * n], [n + next, n + i, 2 * n + 1], [n + i, next, i], [n + i, n + next, next]]];
  polyhedron(points, faces);
}

// A gear of the given module (size) with a bore, and with holes that lighten it where there is room.
module gear(teeth, size, width, bore, holes = 0) {
  root = teeth * size / 2 - 1.2 * size;
  middle = (root + bore) / 2;
  difference() {
    star_prism(gear_outline(teeth, size), width);
    cylinder(h = 2 * width, r = bore, center = true);
    if (holes > 0)
      for (i = [0:holes - 1])
        rotate(i * 360 / holes) translate([middle, 0, 0])
          cylinder(h = 2 * width, r = 0.32 * (root - bore), center = true, $fn = 24);
  }
}

// The turn of a wheel that meshes at +x with a gear whose first tooth lies on the x axis.
function meshing(teeth) = 180 + 180 / teeth;

module ring(outer, inner, width) {
  difference() {
    cylinder(h = width, r = outer, center = true);
    cylinder(h = 2 * width, r = inner, center = true);
  }
}

// A deep-groove ball bearing: two races with a groove, and the balls between them.
module bearing(outer, inner, width, balls = 9) {
  middle = (outer + inner) / 2;
  race = (outer - inner) / 2 * 0.42;
  ball = 0.3 * (outer - inner);
  color("LightSteelBlue") ring(outer, outer - race, width);
  color("LightSteelBlue") ring(inner + race, inner, width);
  color("Gold")
    for (i = [0:balls - 1])
      rotate(i * 360 / balls) translate([middle, 0, 0]) sphere(r = ball, $fn = 16);
}

gear(16, 2, 14, 6, $fn = 48);
translate([(16 + 32) * 2 / 2, 0, 0]) rotate(meshing(32)) gear(32, 2, 12, 8, holes = 6, $fn = 48);
