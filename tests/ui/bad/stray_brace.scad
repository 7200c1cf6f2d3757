cube(1);
}
