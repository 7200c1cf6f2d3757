// A box without a lid, screwed down from inside. docs/inside/box_before.scad is the version before this one.
size = [40, 30, 12];
wall = 5;
floor_height = 6;

difference() {
  cube(size);
  translate([wall, wall, floor_height]) cube([size.x - 2 * wall, size.y - 2 * wall, size.z]);
  translate([10, 15, -1]) cylinder(r = 5, h = 20, $fn = 48);
  translate([30, 15, -1]) cylinder(r = 2, h = 20, $fn = 48);
}
