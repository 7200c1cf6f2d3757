// Glass and wood, cut together.
$fn = 48;
difference() {
    union() {
        color("OrangeRed", 0.4) translate([-12, -6, 0]) cube([12, 12, 8]);
        color("BurlyWood") translate([0, -6, 0]) cube([12, 12, 8]);
    }
    translate([0, 0, 8]) sphere(6);
}
