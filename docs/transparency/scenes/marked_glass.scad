// Glass that is marked, with something in it.
#color("RoyalBlue", 0.4) cube(14, center = true);
sphere(4, $fn = 48);
