// A four-bar linkage: the crank turns once, the rocker swings, the coupler carries a point along a curve.
ground = 40; crank = 12; coupler = 38; rocker = 26;

a = 360 * $t;
joint = crank * [cos(a), sin(a)];                    // crank and coupler
to_rocker = [ground, 0] - joint;
d = norm(to_rocker);
b = atan2(to_rocker.y, to_rocker.x) + acos((coupler * coupler + d * d - rocker * rocker) / (2 * coupler * d));
end = joint + coupler * [cos(b), sin(b)];            // coupler and rocker

module bar(length) difference() {
  hull() { cylinder(h = 3, r = 4, $fn = 48); translate([length, 0, 0]) cylinder(h = 3, r = 4, $fn = 48); }
  for (x = [0, length]) translate([x, 0, -1]) cylinder(h = 5, r = 1.6, $fn = 32);
}
module crank_bar() bar(crank);
module coupler_bar() {
  bar(coupler);
  linear_extrude(3) polygon([[4, 3], [coupler - 4, 3], [coupler / 2, 20]]);
  translate([coupler / 2, 18, 0]) pen();
}
module pen() cylinder(h = 8, r = 1.5, $fn = 32);
module rocker_bar() bar(rocker);

color("#b05030") rotate(a) crank_bar();
color("#4070a0") translate([joint.x, joint.y, 3.2]) rotate(b) coupler_bar();
color("#508050") translate([ground, 0, 0]) rotate(atan2(end.y, end.x - ground)) rocker_bar();
color("#b0b0a8") translate([-10, -8, -4]) cube([ground + 20, 16, 3]);
