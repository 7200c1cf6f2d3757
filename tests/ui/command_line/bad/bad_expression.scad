cube(1 + * 2);
