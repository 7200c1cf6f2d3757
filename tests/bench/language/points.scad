n = 60;
pts = [for (i=[0:n], j=[0:n]) let(a=i*360/n, b=j*360/n) [cos(a)*(3+cos(b)), sin(a)*(3+cos(b)), sin(b)]];
d = [for (k=[0:8:len(pts)-1]) min([for (p=pts) norm(p - pts[k]) + (p == pts[k] ? 100 : 0)])];
echo(max(d), len(d));
for (i=[0:40:len(pts)-1]) translate(pts[i]) cube(0.1);
