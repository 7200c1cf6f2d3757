function join(l, s="", i=0) = i == len(l) ? s : join(l, str(s, l[i], i % 7), i+1);
words = [for (i=[0:3000]) chr([97+i%26, 98+i%20])];
echo(len(join(words)));
function hex(n) = n < 16 ? "0123456789abcdef"[n] : str(hex(floor(n/16)), "0123456789abcdef"[n%16]);
echo(len([for (i=[0:30000]) hex(i*977)]));
