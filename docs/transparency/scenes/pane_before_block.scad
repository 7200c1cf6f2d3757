// The pane stands before the block, and before it in the text.
color("MediumSeaGreen", 0.4) translate([-8, -10, 0]) cube([16, 1, 14]);
color("Goldenrod") translate([-4, -2, 0]) cube(8);
