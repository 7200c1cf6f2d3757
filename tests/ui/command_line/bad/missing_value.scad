width = ;
cube(width);
