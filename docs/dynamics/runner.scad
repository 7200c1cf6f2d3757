// A figure that runs along x while $t runs from 0 to 1; arms and legs swing.
$fn = 24;
stride = 360 * 1.25 * $t;
skin = "#d8b090"; shirt = "#b04838"; trousers = "#506080";

module part(length, r) hull() { sphere(r); translate([0, 0, -length]) sphere(0.75 * r); }
module limb(length, r, angle, bend)
  rotate([0, -angle, 0]) { part(length, r); translate([0, 0, -length]) rotate([0, -bend, 0]) part(length, 0.8 * r); }

module head() color(skin) translate([1.5, 0, 31]) sphere(3.2);
module torso() color(shirt) hull() { translate([0, 0, 17]) sphere(2.6); translate([1, 0, 25]) sphere(3.2); }
module left_arm() color(skin) translate([1, 4, 25]) limb(6, 1.2, 45 * sin(stride), 40);
module right_arm() color(skin) translate([1, -4, 25]) limb(6, 1.2, -45 * sin(stride), 40);
module left_leg() color(trousers) translate([0, 1.8, 16]) limb(7.6, 1.7, -40 * sin(stride), -25);
module right_leg() color(trousers) translate([0, -1.8, 16]) limb(7.6, 1.7, 40 * sin(stride), -25);

translate([80 * $t - 40, 0, 0]) rotate([0, 8, 0]) { head(); torso(); left_arm(); right_arm(); left_leg(); right_leg(); }
color("#c8c8c0") translate([-60, -14, -1.5]) cube([120, 28, 1]);
