union() {
    cube(1);
