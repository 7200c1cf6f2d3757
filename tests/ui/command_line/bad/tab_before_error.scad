	cube(1);
		sphere(2;
