// One polygon of 12,000 points, put together by a function that calls itself.
n = 3000;
function teeth(i = 0) = i == n ? [] : concat([[i * 3, 0], [i * 3 + 0.5, 2], [i * 3 + 1.5, 2], [i * 3 + 2, 0]], teeth(i + 1));
linear_extrude(5) polygon(concat([[0, -1]], teeth(), [[n * 3, -1]]));
