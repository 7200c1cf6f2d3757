module tree(n, l=10) { if (n > 0) { cylinder(r=l/10, h=l); translate([0,0,l]) { rotate([30,0,0]) tree(n-1, l*0.8); rotate([-30,0,90]) tree(n-1, l*0.7); } } }
tree(11);
