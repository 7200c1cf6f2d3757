x = [1, 2;
cube(x);
