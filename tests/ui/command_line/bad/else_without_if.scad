cube(1);
else sphere(1);
