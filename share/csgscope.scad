// The program's icon: what is left of a cube. share/csgscope.png is made of it by
//   csgscope share/csgscope.scad -o share/csgscope.png --imgsize 128,128 --samples 16 --style edges --margin 2 --viewall \
//     --camera 0,0,0,60,0,30,90 --transparent-background
difference() {
    cube(20, center = true);
    sphere(12.4, $fn = 96);
    for (turn = [[0, 0, 0], [90, 0, 0], [0, 90, 0]]) rotate(turn) cylinder(r = 6.5, h = 30, center = true, $fn = 64);
}
color("#2b7de0") sphere(7.6, $fn = 96);
