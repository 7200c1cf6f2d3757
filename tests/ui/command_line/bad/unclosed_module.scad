module outer() {
    if (true) {
        cube(1);
}
outer();
