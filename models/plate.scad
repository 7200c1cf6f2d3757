// A plate with 500 holes: one difference of 501 leaves, which a preview by plain image-based
// CSG draws in hundreds of passes. Two hole sizes alternate, and a rim keeps it a real part.
$fn = 24;

columns = 25;
rows = 20;
pitch = 8;
thickness = 5;
margin = 6;
rim = 3;

size = [columns * pitch + 2 * margin, rows * pitch + 2 * margin];

difference() {
  union() {
    cube([size.x, size.y, thickness]);
    difference() {
      cube([size.x, size.y, thickness + rim]);
      translate([rim, rim, thickness]) cube([size.x - 2 * rim, size.y - 2 * rim, rim]);
    }
  }
  for (i = [0:columns - 1], j = [0:rows - 1])
    translate([margin + (i + 0.5) * pitch, margin + (j + 0.5) * pitch, 0])
      cylinder(h = thickness, r = (i + j) % 2 == 0 ? 2.8 : 1.8);
}
