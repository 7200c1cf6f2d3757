$fn = 48;
difference() {
    cube([16, 16, 6], center = true);
    #cylinder(h = 14, r = 5, center = true);
}
