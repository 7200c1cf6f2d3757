// What docs/STYLES.md shows the styles on: smooth and sharp edges, cuts, colours that meet, hidden parts, one seen through.
$fn = 48;

color("SteelBlue") difference() {
    intersection() {
        cube(15, center = true);
        sphere(10);
    }
    for (turn = [[0, 0, 0], [90, 0, 0], [0, 90, 0]])
        rotate(turn) cylinder(h = 16, r = 4, center = true);
}
rotate([0, 90, 0]) {
    color("Peru") translate([0, 0, -11]) cylinder(h = 20.5, r = 2.5);
    color("Gold") translate([0, 0, 9.5]) cylinder(h = 3, r = 2.5);
}
color("SeaGreen", 0.4) translate([-9, -11, -9]) cube([18, 1, 12]);
