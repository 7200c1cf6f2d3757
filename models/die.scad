// A die: a cube rounded by a ball, its pips cut by smaller balls. Opposite faces add up to seven.
$fn = 48;

side = 16;
rounding = 0.72;  // radius of the ball over the side: 0.71 touches the edges, 0.87 the corners
pip = 1.6;        // radius of a pip at the surface
step = 4.1;       // between neighbouring pips
depth = 0.9;      // of a pip

pip_ball = (pip * pip + depth * depth) / (2 * depth);

// Where the pips of a face lie, as multiples of step.
function spots(count) =
  count == 1 ? [[0, 0]] :
  count == 2 ? [[-1, -1], [1, 1]] :
  count == 4 ? [[-1, -1], [-1, 1], [1, -1], [1, 1]] :
  count == 6 ? [for (x = [-1, 1], y = [-1, 0, 1]) [x, y]] :
  concat(spots(1), spots(count - 1));

// The pips of the upper face.
module pips(count) {
  for (spot = spots(count))
    translate([step * spot.x, step * spot.y, side / 2 - depth + pip_ball])
      sphere(r = pip_ball, $fn = 32);
}

faces = [
  [1, [0, 0, 0]], [6, [180, 0, 0]],
  [2, [90, 0, 0]], [5, [-90, 0, 0]],
  [3, [0, 90, 0]], [4, [0, -90, 0]],
];

difference() {
  color("Ivory") intersection() {
    cube(side, center = true);
    sphere(r = rounding * side, $fn = 96);
  }
  for (face = faces)
    color(face[0] == 1 ? "Crimson" : "DarkSlateGray") rotate(face[1]) pips(face[0]);
}
