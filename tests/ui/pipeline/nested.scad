// Small and nested: a difference of a difference within an intersection, with shared faces.
intersection() {
  difference() {
    cube(10);
    difference() {
      translate([2, 2, 0]) cube([6, 6, 10]);
      translate([4, 4, 0]) cube([2, 2, 10]);
    }
    translate([50, 0, 0]) cube(5);
  }
  union() {
    cube([10, 10, 4]);
    translate([0, 0, 6]) cube([10, 10, 4]);
  }
}
