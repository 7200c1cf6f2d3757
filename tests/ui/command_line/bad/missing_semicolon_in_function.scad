function f(x) = x + 1
cube(f(1));
