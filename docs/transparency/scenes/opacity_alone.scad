// Opacity without a color.
color(alpha = 0.35) cube(14, center = true);
color("RoyalBlue") sphere(5, $fn = 48);
