// The distance of the sheet that noise lies on (npr/styles/relief.h), at a place in pixels from the middle of the picture:
// a quadratic spline through its cells. Valid in shaders and, within a struct with the same names, in C++.
float relief_at(vec2 place) {
    vec2 g = place / relief_cell + vec2(relief_size() / 2);
    ivec2 cell = ivec2(floor(g));
    vec2 f = g - vec2(cell) - 0.5f;
    vec3 x = vec3(0.5f * (0.5f - f.x) * (0.5f - f.x), 0.75f - f.x * f.x, 0.5f * (0.5f + f.x) * (0.5f + f.x));
    vec3 y = vec3(0.5f * (0.5f - f.y) * (0.5f - f.y), 0.75f - f.y * f.y, 0.5f * (0.5f + f.y) * (0.5f + f.y));
    float sum = 0.0f;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i)
            sum += x[i] * y[j] * relief_distance(clamp(cell + ivec2(i - 1, j - 1), ivec2(0), relief_size() - 1));
    }
    return sum;
}
