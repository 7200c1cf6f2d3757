// A plate with a hole and a post.
wall = 3;
difference() {
    cube([40, 30, 6]);
    translate([10, 15, -1]) cylinder(d = 8, h = 8, $fn = 48);
}
translate([wall * 8, 10, 6]) cube([10, 10, 15]);  // the post
