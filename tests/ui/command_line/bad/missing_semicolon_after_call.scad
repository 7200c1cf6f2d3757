cube(1)
b = 2;
