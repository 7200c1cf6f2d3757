a = 1
cube(a);
