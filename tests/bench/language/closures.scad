compose = function (f, g) function (x) f(g(x));
add = function (k) function (x) x + k;
function fold(f, a, l, i=0) = i == len(l) ? a : fold(f, f(a, l[i]), l, i+1);
inc = compose(add(1), compose(add(2), add(-2)));
echo(fold(function (a, x) a + inc(x), 0, [for (i=[1:60000]) i]));
