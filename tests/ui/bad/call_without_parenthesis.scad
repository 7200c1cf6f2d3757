difference {
    cube(2);
}
