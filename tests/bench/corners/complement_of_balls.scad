// A block with a cavity of two balls, grown by a ball.
$fn = 8;
minkowski() {
    difference() {
        translate([-4, -4, -4]) cube(32);
        union() { sphere(5); translate([6, 0, 0]) rotate([10, 20, 30]) sphere(5); }
    }
    sphere(1);
}
