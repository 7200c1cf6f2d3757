// A curve turned about an axis, with two rims.
rotate_extrude($fn = 72) polygon(concat([[0, 0], [14, 0], [14, 1.5]],
    [for (i = [1:20]) let (t = i / 20) [2 + 12 * (1 - t) ^ 3, 1.5 + 20 * t]],
    [for (i = [1:20]) let (a = 90 * i / 20) [2 + 14 * sin(a), 21.5 + 20 * (1 - cos(a))]],
    [[15, 41.5]],
    [for (i = [1:20]) let (a = 90 - 90 * i / 20) [15 * sin(a), 23.5 + 18 * (1 - cos(a))]]));
