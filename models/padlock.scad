// A pin tumbler padlock with its key. From outside a block of brass; a blueprint shows the pins,
// each as long as the cut of the key below it asks for, their springs, and the balls that hold the shackle.
$fn = 32;

body = [48, 20, 42];    // the block stands on z = 0, x across
corner = 6;
chamfer = 1.2;

rod = 4;                // radius of the shackle
span = 15;              // from its middle to each leg
bend = body.z + 12;     // height of the centre of its arc
heel = 7;               // height of the end of its long leg
toe = 25;               // and of its short one

plug = 6;               // radius of the core that turns with the key
plug_height = 24;
cam_top = 34;
ball = 3.2;
ball_at = [8.6, 29.5];  // how far from the axis, how high

pin = 1.4;              // radius of pins; their chambers have a little play
pins_at = [4.5, 8.8, 13.1, 17.4, 21.7];
cuts = [2, 5, 1, 4, 3]; // depth of the cuts of the key, in steps
step = 0.7;
blade = [6.4, 2, 23];   // of the key: across, thick, long
blade_top = 2.6;        // the edge with the cuts is that far from the axis
chamber_end = 19;       // where the springs rest against their screws

function cut_top(i) = blade_top - cuts[i] * step;

// A body through rings of equally many points, each ring counter-clockwise about the way through all of them.
module loft(rings) {
  n = len(rings[0]);
  last = n * (len(rings) - 1);
  sides = [for (r = [0:len(rings) - 2], i = [0:n - 1])
    let (a = r * n + i, b = r * n + (i + 1) % n) each [[a, a + n, b + n], [a, b + n, b]]];
  polyhedron([for (ring = rings) each ring],
             concat(sides, [[for (i = [0:n - 1]) i]], [[for (i = [n - 1:-1:0]) last + i]]));
}

// The outline of a rectangle with round corners, at height z.
function rounded(size, radius, z) =
  [for (quarter = [0:3], i = [0:6])
    let (angle = 90 * quarter + 15 * i,
         middle = [(size.x / 2 - radius) * (quarter % 3 == 0 ? 1 : -1), (size.y / 2 - radius) * (quarter < 2 ? 1 : -1)])
    [middle.x + radius * cos(angle), middle.y + radius * sin(angle), z]];

module block() {
  loft([for (level = [[0, 1], [chamfer, 0], [body.z - chamfer, 0], [body.z, 1]])
    rounded(body - 2 * level[1] * chamfer * [1, 1, 0], corner - level[1] * chamfer, level[0])]);
}

module shackle() {
  arc = [for (angle = [180:-10:0]) [span * cos(angle), bend + span * sin(angle), angle - 90]];
  path = concat([[-span, heel, 90]], arc, [[span, toe, -90]]);
  difference() {
    loft([for (p = path) [for (i = [0:23])
      [p[0] - rod * cos(15 * i) * -sin(p[2]), rod * sin(15 * i), p[1] - rod * cos(15 * i) * cos(p[2])]]]);
    balls(1.04);
    // The toe comes free when the shackle is drawn out; the groove of the heel then keeps it in.
    translate([-span, 0, heel + 3]) difference() {
      cylinder(h = 3, r = rod + 1);
      cylinder(h = 3, r = rod - 1.2);
    }
  }
}

module balls(grow = 1) {
  for (side = [-1, 1]) translate([side * ball_at[0], 0, ball_at[1]]) sphere(r = ball * grow);
}

// All that is bored out of the block.
module bores() {
  translate([0, 0, -1]) cylinder(h = plug_height + 1.4, r = plug + 0.1);
  translate([0, 0, plug_height]) cylinder(h = cam_top - plug_height + 0.5, r = plug - 0.2);
  translate([-span, 0, heel - 2]) cylinder(h = body.z, r = rod + 0.3);
  translate([span, 0, toe - 1]) cylinder(h = body.z, r = rod + 0.3);
  translate([0, 0, ball_at[1]]) rotate([0, 90, 0]) cylinder(h = 2 * span, r = ball + 0.1, center = true);
  for (z = pins_at) translate([plug - 1, 0, z]) rotate([0, 90, 0]) cylinder(h = body.x, r = pin + 0.15);
}

module core() {
  difference() {
    cylinder(h = plug_height, r = plug);
    translate([blade_top - blade.x - 0.3, -blade.y / 2 - 0.2, -1]) cube([blade.x + 0.6, blade.y + 0.4, plug_height]);
    for (z = pins_at) translate([0, 0, z]) rotate([0, 90, 0]) cylinder(h = plug + 1, r = pin + 0.15);
  }
}

// The cam stands between the balls; a quarter turn of it gives them room in its flats.
module cam() {
  width = ball_at[0] - ball;
  difference() {
    translate([0, 0, plug_height]) cylinder(h = cam_top - plug_height, r = width);
    for (side = [-1, 1])
      translate([-width, side * (width + 1) - width / 2, ball_at[1] - ball - 0.5]) cube([2 * width, width, 2 * ball + 1]);
  }
}

module spring(from, to, turns) {
  wire = 0.3;
  steps = 12 * turns;
  loft([for (s = [0:steps]) let (angle = 30 * s) [for (i = [0:5])
    let (radius = pin - wire + wire * cos(60 * i))
    [from + wire + (to - from - 2 * wire) * s / steps - wire * sin(60 * i), radius * cos(angle), radius * sin(angle)]]]);
}

module pin_stack(i) {
  tip = 1.1;
  key_pin = plug - cut_top(i);
  driver = 4.5;
  translate([0, 0, pins_at[i]]) {
    rotate([0, 90, 0]) {
      color("Tomato") translate([0, 0, cut_top(i)]) {
        cylinder(h = tip, r1 = 0.4, r2 = pin);
        translate([0, 0, tip]) cylinder(h = key_pin - tip, r = pin);
      }
      color("RoyalBlue") translate([0, 0, plug]) cylinder(h = driver, r = pin);
      color("Goldenrod") translate([0, 0, chamber_end]) cylinder(h = 3, r = pin);
    }
    color("DimGray") spring(plug + driver, chamber_end, 5);
  }
}

module key() {
  bow = 11;
  difference() {
    union() {
      translate([blade_top - blade.x, -blade.y / 2, -6]) cube([blade.x, blade.y, blade.z + 6]);
      translate([-5.5, -blade.y / 2, -8]) cube([9, blade.y, 6]);
      translate([-1, 0, -8 - 0.8 * bow]) rotate([90, 0, 0]) cylinder(h = blade.y, r = bow, center = true, $fn = 48);
    }
    translate([-1, 0, -8 - 1.2 * bow]) rotate([90, 0, 0]) cylinder(h = 2 * blade.y, r = 3.2, center = true);
    for (i = [0:len(cuts) - 1])
      translate([cut_top(i), 0, pins_at[i]]) rotate([0, 45, 0]) translate([0, -blade.y, 0]) cube([6, 2 * blade.y, 6]);
    translate([blade_top, -blade.y, blade.z]) rotate([0, 45, 0]) cube([6, 4 * blade.y, 6], center = true);
  }
}

color("Goldenrod") difference() { block(); bores(); }
color("Silver") shackle();
color("Peru") core();
color("SlateGray") cam();
color("LightSteelBlue") balls();
for (i = [0:len(cuts) - 1]) pin_stack(i);
color("Gainsboro") key();
