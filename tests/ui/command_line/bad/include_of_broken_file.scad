include <stray_brace.scad>
cube(1);
