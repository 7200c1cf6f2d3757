module m() { m(); }
m();
