cube(1));
