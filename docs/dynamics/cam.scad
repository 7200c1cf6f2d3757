// A cam turns once; a flat-faced follower rides on it, pushed up by the lobe.
base = 12; nose = 5; lobe = 14;  // Radii of the circles whose hull the cam is, and how far apart they are.

a = 360 * $t - 60;
lift = max(base, lobe * sin(a) + nose);  // How far the hull reaches up: the larger of both circles' tops.

module cam() difference() {
  hull() {
    cylinder(h = 8, r = base, $fn = 96);
    translate([lobe, 0, 0]) cylinder(h = 8, r = nose, $fn = 96);
  }
  translate([0, 0, -1]) cylinder(h = 10, r = 4, $fn = 48);
}
module follower() {
  translate([-10, 0, 0]) cube([20, 3, 8]);
  translate([-3, 0, 1]) cube([6, 46, 6]);
}
module guide() difference() {
  translate([-12, 30, -1]) cube([24, 12, 10]);
  translate([-3.2, 29, 0.8]) cube([6.4, 14, 6.4]);
}
module axle() translate([0, 0, -4]) cylinder(h = 16, r = 3.9, $fn = 48);

color("#b05030") rotate(a) cam();
color("#4070a0") translate([0, lift, 0]) follower();
color("#b0b0a8") guide();
color("#808078") axle();
