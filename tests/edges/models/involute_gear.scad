// Flanks are involutes of a few points; tips and roots are corners.
teeth = 18;
base = 16;
outer = 20;
root = 15;
function involute(t) = base * [cos(t) + t * PI / 180 * sin(t), sin(t) - t * PI / 180 * cos(t)];
function turned(p, a) = [p.x * cos(a) - p.y * sin(a), p.x * sin(a) + p.y * cos(a)];
last = sqrt((outer / base) ^ 2 - 1) * 180 / PI;
flank = [for (i = [0:8]) involute(last * i / 8)];
half = 90 / teeth + 2;
tooth = [for (p = concat([[root, 0]], flank)) turned(p, -half)];
difference() {
    linear_extrude(8) polygon([for (k = [0:teeth - 1]) let (a = 360 * k / teeth)
        each concat([for (p = tooth) turned(p, a)], [for (i = [len(tooth) - 1:-1:0]) turned([tooth[i].x, -tooth[i].y], a)])]);
    translate([0, 0, -1]) cylinder(r = 5, h = 10, $fn = 48);
    for (a = [0:60:300]) rotate(a) translate([10, 0, -1]) cylinder(r = 2, h = 10, $fn = 32);
}
