// Width of the box
width = 10; // [5:100]
/* [Lid] */
// Kind of lid
kind = "flat"; // [flat:Flat lid, round:Round "lid"]
height = 2.5; // .5
/* [Hidden] */
$fn = 20;
inner = width - 2; // not a parameter
module box() { }
late = 1; // too late
