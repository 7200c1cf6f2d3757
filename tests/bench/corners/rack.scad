// Teeth whose flanks are evaluated point by point, each for itself.
n = 2000;
function bend(a) = tan(a) * 180 / PI - a;
function flank(i, k = 12) = [for (t = [0 : k]) let (a = 20 * t / k)
    [i * PI + 0.2 + t / k * 0.5 * (1 + bend(a) / 90), t / k * 2]];
function tooth(i) = concat(flank(i), [for (t = [12 : -1 : 0]) let (p = flank(i)[t]) [(2 * i + 1) * PI - p[0], p[1]]]);
linear_extrude(5) {
    translate([0, -1]) square([n * PI, 1.1]);
    for (i = [0 : n - 1]) polygon(tooth(i));
}
