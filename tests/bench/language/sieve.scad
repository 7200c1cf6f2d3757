function prime(n, d=2) = d*d > n ? true : n % d == 0 ? false : prime(n, d+1);
echo(len([for (i=[2:30000]) if (prime(i)) i]));
