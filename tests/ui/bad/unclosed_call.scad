cube(10;
