include <shapes.scad
cube(1);
