color("OrangeRed", 0.5) cube([24, 6, 6], center = true);
color("RoyalBlue", 0.5) cube([6, 24, 6], center = true);
