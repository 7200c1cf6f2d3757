// A body of glass, cut by something of another color.
$fn = 48;
difference() {
    color("OrangeRed", 0.4) cube(12, center = true);
    color("RoyalBlue") cylinder(h = 20, r = 4, center = true);
}
