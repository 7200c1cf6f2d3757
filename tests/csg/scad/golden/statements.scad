module plate(size = 10, holes = [1, 2]) {
    thickness = 2;
    function at(i) = [i * size, 0, 0];
    difference() {
        cube([size, size, thickness]);
        for (i = holes) translate(at(i)) cylinder(r = 1, h = 3);
        *sphere();
    }
}

module pair() { children(0); if ($children > 1) { children(1); } else echo("one"); }

size = 20;
size = 30;
!plate(size);
pair() {
    #cube();
    %sphere(r = 2, $fn = 12);
}
if (size > 10) cube();
else if (size > 5) { sphere(); cube(); }
else { }
{
    loose = 1;
    translate([loose, 0]) { }
}
