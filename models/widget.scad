// The classic of constructive solid geometry: a ball cut to a box, drilled along its three axes.
$fn = 64;

side = 20;  // edge of the box
ball = 13;  // radius of the ball: between side/2 and side/2*sqrt(3) it rounds the corners only
bore = 5;   // radius of the three holes

module bores(length, radius) {
  cylinder(h = length, r = radius, center = true);
  rotate([90, 0, 0]) cylinder(h = length, r = radius, center = true);
  rotate([0, 90, 0]) cylinder(h = length, r = radius, center = true);
}

difference() {
  color("SteelBlue") intersection() {
    sphere(r = ball);
    cube(side, center = true);
  }
  color("Gold") bores(2 * side, bore);
}
