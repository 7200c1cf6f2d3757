a = true ? 1;
