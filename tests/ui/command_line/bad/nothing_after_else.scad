if (true) cube(1); else
