// A ball that is thrown, while $t runs from 0 to 1.
module ball() difference() {
  sphere(5, $fn = 64);
  for (side = [-1, 1]) translate([0, 5.5 * side, 0]) rotate([90, 0, 0])
    rotate_extrude($fn = 64) translate([4, 0]) circle(0.5, $fn = 12);
}
color("#e8dcc0") translate([110 * $t - 55, 0, 44 * 4 * $t * (1 - $t) * 0.6]) rotate([0, 200 * $t, 0]) ball();
