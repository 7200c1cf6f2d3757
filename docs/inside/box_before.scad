// models/box.scad as it was: lower, with one narrower hole.
size = [40, 30, 10];
wall = 5;
floor_height = 6;

difference() {
  cube(size);
  translate([wall, wall, floor_height]) cube([size.x - 2 * wall, size.y - 2 * wall, size.z]);
  translate([10, 15, -1]) cylinder(r = 4, h = 20, $fn = 48);
}
