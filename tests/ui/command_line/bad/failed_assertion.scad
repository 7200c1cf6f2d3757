size = -1;
assert(size > 0, "size must be positive");
cube(size);
