module m() {
    use <shapes.scad>
}
