function mat(n, s) = [for (i=[0:n-1]) [for (j=[0:n-1]) sin(i*s+j)]];
function mul(a, b) = [for (i=[0:len(a)-1]) [for (j=[0:len(b[0])-1]) let(c=[for (k=[0:len(b)-1]) b[k][j]]) a[i]*c]];
m = mat(40, 17);
echo(norm(mul(mul(m, m), m)[3]));
r = [for (i=[0:20000]) let(a=i) [[cos(a),-sin(a),0],[sin(a),cos(a),0],[0,0,1]] * [1,2,3]];
echo(r[12345]);
