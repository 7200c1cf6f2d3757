if true cube(1);
