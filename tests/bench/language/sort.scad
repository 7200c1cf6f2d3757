function qs(v) = len(v) <= 1 ? v : let(p=v[floor(len(v)/2)]) concat(qs([for (x=v) if (x<p) x]), [for (x=v) if (x==p) x], qs([for (x=v) if (x>p) x]));
v = rands(0, 1000, 20000, 42);
s = qs(v);
echo(s[0], s[10000], s[19999]);
