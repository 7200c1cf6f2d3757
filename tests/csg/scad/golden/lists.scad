plain = [for (i = [0:3], j = "ab") [i, j]];
nested = [for (i = plain) let (k = i[0]) if (k > 1) each i else if (k > 0) k];
loop = [for (i = 0, j = 1; i < 5; i = i + 1, j = j * 2) if (j % 2 == 0) j];
mixed = [-1, each [1, 2], (for (i = [1:2]) i), let (a = 1) a, (if (plain) 1), 2];
