// A batter hits a ball while $t runs from 0 to 1: the ball comes until 0.5, and leaves twice as fast.
$fn = 32;
hit = 0.5;
skin = "#d8b090"; shirt = "#4060a0"; wood = "#a87038";

function ease(a) = a * a * (3 - 2 * a);
// Degrees about the vertical axis: back at first, across the plate at the hit, far around at the end.
turn = $t < 0.2 ? -100 : -100 + 220 * ease(min(1, ($t - 0.2) / 0.6));
// Where the thick end of the bat is at the hit.
plate = [24 * cos(10), 24 * sin(10), 22];
away = [1, 0.35, 0.3];
ball_at = $t < hit ? plate + (hit - $t) * [80, -30, 4] : plate + ($t - hit) * 170 * away / norm(away);

module limb(a, b, r) hull() { translate(a) sphere(r); translate(b) sphere(0.8 * r); }
module body() {
  color(shirt) hull() { translate([0, 0, 20]) sphere(4); translate([0, 0, 30]) sphere(4.6); }
  color(skin) translate([0, 0, 38]) sphere(3.6);
  color("#606060") { limb([0, 2, 18], [-3, 8, 1], 2.2); limb([0, -2, 18], [3, -8, 1], 2.2); }
}
module arms() color(skin) { limb([2, 4, 30], [9, 0, 22], 1.5); limb([2, -4, 30], [9, 0, 22], 1.5); }
// The bat, and the arms that hold it.
module bat() {
  arms();
  color(wood) translate([9, 0, 22]) rotate([0, 90, 0]) {
    cylinder(h = 18, r1 = 0.7, r2 = 1.5); translate([0, 0, 18]) sphere(1.5); translate([0, 0, -1]) sphere(1.1);
  }
}
module ball() color("#f0f0e8") sphere(1.7);

body();
rotate([0, 0, turn]) bat();
translate(ball_at) ball();
color("#b0c0a0") translate([0, 0, -1]) cylinder(h = 1, r = 16);
