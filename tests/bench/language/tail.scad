function sum(n, a=0) = n == 0 ? a : sum(n-1, a+n*n%7);
echo(sum(900000));
