// The fronts of the two lie in one plane where they overlap.
color("OrangeRed", 0.5) translate([-10, 0, 0]) cube([14, 10, 10]);
color("RoyalBlue", 0.5) translate([-4, 0, 0]) cube([14, 10, 6]);
