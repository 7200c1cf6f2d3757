// What is left of struts when what is around them grows: a Minkowski sum of a complement, twice.
$fn = 8;
module strut(a, b) hull() { translate(a) sphere(2); translate(b) sphere(2); }
module struts() { strut([0, 0, 0], [20, 0, 0]); strut([0, 0, 0], [0, 20, 0]); strut([0, 0, 0], [0, 0, 20]); strut([20, 0, 0], [0, 20, 0]); }
difference() {
    translate([-3, -3, -3]) cube([28, 28, 20]);
    minkowski() {
        difference() { translate([-4, -4, -4]) cube(32); minkowski() { struts(); sphere(1); } }
        sphere(1);
    }
}
