module if() cube(1);
