// Three balls that are let fall one after another, and bounce, while $t runs from 0 to 1.
module red_ball() color("#d04030") sphere(4, $fn = 64);
module green_ball() color("#40904c") sphere(4, $fn = 64);
module blue_ball() color("#4060c0") sphere(4, $fn = 64);

function height(t, top) = let (fall = 0.36 * sqrt(top / 24))
  t < 0 ? top : t < fall ? top * (1 - pow(t / fall, 2)) : bounce(t - fall, 0.6 * top);
function bounce(t, top) = let (fall = 0.36 * sqrt(top / 24))
  t < 2 * fall ? 4 * top * (t / (2 * fall)) * (1 - t / (2 * fall)) : bounce(t - 2 * fall, 0.6 * top);

translate([22 * $t - 30, -6, 4 + height($t, 24)]) red_ball();
translate([22 * $t - 6, 0, 4 + height($t - 0.15, 24)]) green_ball();
translate([22 * $t + 18, 6, 4 + height($t - 0.3, 24)]) blue_ball();
color("#c8c8c0") translate([-42, -16, -2]) cube([92, 34, 2]);
