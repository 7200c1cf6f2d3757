cube(1);
/* never ends
