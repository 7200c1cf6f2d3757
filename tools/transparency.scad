// The subject of docs/transparency: a shaft in a housing of glass that is bored and cut open, a ball that crosses the
// housing's wall, a guard for orientation (%) and a marked key (#).
$fn = 64;

module shaft() {
    color("SteelBlue") {
        translate([0, 0, -26]) cylinder(h = 56, r = 5);
        cylinder(h = 6, r = 13);
    }
    #translate([4, -1.5, 16]) cube([4, 3, 12]);
}

difference() {
    union() {
        color("PaleGreen", 0.4) translate([-20, -20, -18]) cube([40, 40, 32]);
        color("SlateGray") translate([-24, -24, -22]) cube([48, 48, 4]);
    }
    translate([0, 0, -30]) cylinder(h = 50, r = 15);
    color("Red") translate([8, -30, 2]) cube([30, 30, 30]);
}
shaft();
color("OrangeRed", 0.55) translate([-18, -14, 10]) sphere(11);
color("RoyalBlue", 0.5) translate([-2, 12, -8]) cube([28, 12, 14]);
%translate([0, 0, 24]) difference() {
    cylinder(h = 5, r = 18);
    translate([0, 0, -1]) cylinder(h = 7, r = 15);
}
