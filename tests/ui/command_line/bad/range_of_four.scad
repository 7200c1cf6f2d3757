for (i = [0:1:2:3]) cube(i);
