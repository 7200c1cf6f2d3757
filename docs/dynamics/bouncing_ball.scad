// A ball that bounces, lower each time, while $t runs from 0 to 1.
module ball() sphere(4, $fn = 64);
module floor() cube([84, 30, 2]);

function height(t, top) = let (fall = 0.42 * sqrt(top / 20))
  t < fall ? 4 * top * (t / fall) * (1 - t / fall) : height(t - fall, 0.55 * top);

color("#d04030") translate([60 * $t - 30, 0, 4 + height($t, 20)]) ball();
color("#c8c8c0") translate([-42, -15, -2]) floor();
