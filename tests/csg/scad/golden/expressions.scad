a = 1 + 2 * 3 - -4 ^ 2 % 5;
b = a > 1 && !(a < 2) || a == 3 ? "yes" : a != 4 ? undef : [a, true, false];
c = a | 1 & 6 << 2 >> ~1;
d = [0 : 2 : 10].step + b[0].x;
f = function(x, y = 2) let(z = x * y) assert(z > 0, "positive") echo(z = z) z;
g = f(1)(2)(y = 3);
function h(n) = n <= 0 ? [] : concat([n], h(n - 1));
s = "tab\t quote\" back\\ line\n \u2698";
n = [1e6, 1e-7, 0xff, .5, 100.0625];
