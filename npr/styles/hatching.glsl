// Tone by hatching: pencil strokes side by side, in a direction for each main direction of the surface. Valid in
// shaders and, within a struct with the same names, in C++.

// One light from the upper left; surfaces that turn away from it get no light at all.
float sketch_light(Surface s) {
    vec3 n = mat3(view.eye_from_world) * s.normal;
    float direct = dot(n, vec3(-0.55700665f, 0.65828059f, 0.50636968f));
    return clamp(0.2f + 0.45f * direct + 0.35f * n.z, 0.0f, 1.0f);
}

// Unit vector along the strokes of a family: three for the main directions, one that crosses them.
vec2 strokes_along(uint family) {
    if (family == 0u)
        return vec2(-0.37018083f, 0.92895972f);
    if (family == 1u)
        return vec2(0.57351999f, 0.81919157f);
    return family == 2u ? vec2(0.95533649f, 0.29552021f) : vec2(-0.80114362f, 0.59847214f);
}

// A family of parallel strokes: coverage of `at` (pixels). `weight` from 0 to 1 thins and thickens them.
float stroke_family(vec2 at, uint family, float spacing, float weight) {
    vec2 along = strokes_along(family);
    float v = dot(at, along);
    float u = dot(at, vec2(-along.y, along.x)) / spacing;
    float line = floor(u);
    vec3 own = white_noise(ivec2(int(line), int(family)), seed);
    // Strokes of uneven length and place, each a little lighter at its ends.
    float reach = spacing * (9.0f + 9.0f * own.x);
    float part = fract(v / reach + own.y);
    float ends = smoothstep(0.0f, 0.16f, part) * (1.0f - smoothstep(0.8f, 1.0f, part));
    float beside = abs(u - line - 0.5f + 0.3f * (own.z - 0.5f)) * spacing;
    float thick = (0.3f + 0.9f * weight) * max(0.55f * unit, 0.7f);
    return clamp(0.5f * thick + 0.5f - beside, 0.0f, 1.0f) * ends * min(1.0f, 0.35f + weight);
}

// `shadow` from 0 (paper) to 1.
float hatching(vec2 at, vec3 normal, float shadow) {
    vec3 w = normal * normal;
    w *= w;
    w /= w.x + w.y + w.z;
    float spacing = 4.2f * unit;
    float ink = 0.0f;
    float dim = smoothstep(0.28f, 0.9f, shadow);
    for (int k = 0; k < 3; ++k) {
        float weight = smoothstep(0.15f, 0.5f, w[k]) * dim;
        if (weight > 0.02f)
            ink = max(ink, weight * stroke_family(at, uint(k), spacing, weight));
    }
    // Crossed where it is darkest.
    float dark = smoothstep(0.62f, 0.95f, shadow);
    if (dark > 0.02f)
        ink = max(ink, dark * stroke_family(at, 3u, 1.15f * spacing, dark));
    return ink;
}
