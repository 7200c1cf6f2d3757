function f(1) = 2;
