function shape(l) = [for (; is_list(l) && len(l) > 0; l = l[0]) len(l)];
echo(shape([[1, 2], 3]));
