module m(a, for) cube(a);
