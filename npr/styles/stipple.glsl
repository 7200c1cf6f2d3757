// Stippling: dots on the model, as many and as large as the tone asks for. Dots lie in the squares of a lattice in that
// plane of the world's axes to which the surface is most parallel, each at a place of its own; what a projection does to
// areas it does to dots and to the squares alike, so that the share of ink is the tone's. As squares grow or shrink in
// the picture, the dots of lattices give way to those of the next finer or coarser ones. Valid in shaders and, within a
// struct with the same names, in C++.

// Coverage of a pixel by a disc; in pixels. A soft rim leaves as much ink as a hard one.
float disc_cover(float distance, float radius) {
    float least = 0.6f;
    float r = max(radius, least);
    float soft = sqrt(r * r - 1.0f / 12.0f);
    return clamp(soft - distance + 0.5f, 0.0f, 1.0f) * min(radius * radius / (least * least), 1.0f);
}

// Coverage by the dots of one lattice. `at`: in its squares; `right`, `above`: how far it goes on in neighboring pixels.
// Up to half of a square; `own`: lattices differ.
float dots(vec2 at, vec2 right, vec2 above, float tone, uint own) {
    float radius = sqrt(tone / 3.14159265f);  // of a square's side
    float room = 0.5f - radius;               // for the dot's own place
    vec2 low = floor(at - 0.5f);
    float cover = 0.0f;
    for (int i = 0; i < 4; ++i) {
        vec2 square = low + vec2(float(i & 1), float(i >> 1));
        vec3 place = white_noise(ivec2(square), own);
        vec2 from_dot = at - square - 0.5f - 2.0f * max(room, 0.0f) * (vec2(place) - 0.5f);
        float far = length(from_dot);
        // Of a pixel, in the direction of the dot.
        vec2 direction = from_dot / max(far, 1e-6f);
        float a_pixel = length(vec2(dot(right, direction), dot(above, direction)));
        cover = max(cover, disc_cover(far / max(a_pixel, 1e-6f), radius / max(a_pixel, 1e-6f)));
    }
    return cover;
}

// The same for all tones: dots of paper where it is darker than half.
float lattice(vec2 at, vec2 right, vec2 above, float tone, uint own) {
    return tone > 0.5f ? 1.0f - dots(at, right, above, 1.0f - tone, own) : dots(at, right, above, tone, own);
}

// Along the rows of the k-th of eight lattices: at 8, 53, 30, 75, 19, 64, 41 and 86 degrees.
vec2 rows_along(int k) {
    if (k == 0)
        return vec2(0.99026807f, 0.13917310f);
    if (k == 1)
        return vec2(0.60181502f, 0.79863551f);
    if (k == 2)
        return vec2(0.86602540f, 0.50000000f);
    if (k == 3)
        return vec2(0.25881905f, 0.96592583f);
    if (k == 4)
        return vec2(0.94551858f, 0.32556815f);
    if (k == 5)
        return vec2(0.43837115f, 0.89879405f);
    if (k == 6)
        return vec2(0.75470958f, 0.65605903f);
    return vec2(0.06975647f, 0.99756405f);
}

// What two lattices of a level leave bare: the product of what each does. They are turned against each other, so that
// neither is seen.
float lattices(vec2 at, vec2 right, vec2 above, float level, float tone, uint own) {
    if (tone < 0.002f)
        return 1.0f;
    float bare = 1.0f;
    float scale = exp2(-level);
    for (int i = 0; i < 2; ++i) {
        int k = 2 * int(level) + i;
        vec2 row = scale * rows_along(k & 7);
        mat2 turn = mat2(row.x, -row.y, row.y, row.x);
        bare *= 1.0f - lattice(turn * at, turn * right, turn * above, tone, own * 256u + uint(k + 128));
    }
    return bare;
}

// Coverage of a pixel where the surface is to have that tone.
float tonal_ink(Surface s, ivec2 pixel, float tone) {
    if (tone <= 0.0f)
        return 0.0f;
    Place p = place_on(s.plane, pixel);
    vec3 n = abs(s.normal);
    vec3 e = n.x > max(n.y, n.z) ? vec3(0.0f, 1.0f, 0.0f) : vec3(1.0f, 0.0f, 0.0f);
    vec3 f = n.z >= max(n.x, n.y) ? vec3(0.0f, 1.0f, 0.0f) : vec3(0.0f, 0.0f, 1.0f);
    vec2 right = vec2(dot(p.right, e), dot(p.right, f));
    vec2 above = vec2(dot(p.above, e), dot(p.above, f));
    float side = sqrt(abs(right.x * above.y - right.y * above.x));  // of a pixel, on the lattice
    float level = log2(max(spacing * side, 1e-30f));
    float coarse = ceil(level);
    float finer = coarse - level;  // how much of the tone is the next finer lattices'
    uint own = seed * 4u + (n.z >= max(n.x, n.y) ? 0u : n.x > n.y ? 1u : 2u);
    vec2 at = vec2(dot(p.here, e), dot(p.here, f));
    float bare = lattices(at, right, above, coarse, 1.0f - pow(1.0f - tone, 0.5f - 0.5f * finer), own);
    bare *= lattices(at, right, above, coarse - 1.0f, 1.0f - pow(1.0f - tone, 0.5f * finer), own);
    return 1.0f - bare;
}

#include "npr/styles/tonal_ink.glsl"
