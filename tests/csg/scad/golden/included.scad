x = 1;
include <part/shared.txt>
use <part/shared.txt>
y = shared;
shared = 3;
