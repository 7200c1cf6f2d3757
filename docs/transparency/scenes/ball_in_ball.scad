// The outer ball comes first.
$fn = 48;
color("OrangeRed", 0.4) sphere(10);
color("RoyalBlue", 0.8) sphere(5);
