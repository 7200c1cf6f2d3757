x = [for (i = 0;; i = i + 1) i];
