// A vase whose wall is one smooth surface.
difference() {
    linear_extrude(60, twist = 70, slices = 60, scale = 1.4) lobes(20);
    translate([0, 0, 3]) linear_extrude(60, twist = 70, slices = 60, scale = 1.4) lobes(17.5);
}
module lobes(r)
    polygon([for (i = [0:119]) let (a = 3 * i) (r + 2.5 * sin(6 * a)) * [cos(a), sin(a)]]);
