// Hatching whose strokes follow the surface (Nienhaus 2005, 4.6): a tonal art map (Praun et al. 2001) that is computed
// instead of stored. Strokes are where a surface meets parallel planes: rings about the axis of its leaf, which on
// cylinders, cones, spheres and extrusions run along the surface. They are prioritised: every other one is one of the
// next coarser map, too. As they come apart in the picture, those between grow, and as they come together these vanish,
// and the ink on a surface stays what its tone asks for. Valid in shaders and, within a struct with the same names, in
// C++.

// Coverage of a pixel by a stroke, at a distance across it; in pixels.
float stroke_cover(float beside, float wide) {
    return max(min(beside + 0.5f, 0.5f * wide) - max(beside - 0.5f, -0.5f * wide), 0.0f);
}

// Coverage by the strokes across a direction (unit vector). `tone`: of all of the surface.
float stroke_family(Place p, vec3 across, float tone) {
    float a_pixel = length(rate(p, across));
    if (a_pixel <= 0.0f || tone <= 0.0f)
        return 0.0f;
    float period = exp2(ceil(log2(spacing * a_pixel)));
    float apart = period / a_pixel;                             // pixels, from `spacing` to twice as much
    float fresh = smoothstep(0.0f, 0.35f, apart / spacing - 1.0f);  // how much the strokes between have grown
    float place = dot(p.here, across) / period;
    float nearest = floor(place + 0.5f);
    float cover = 0.0f;
    for (int i = -1; i <= 1; ++i) {
        float line = nearest + float(i);
        bool between = abs(line - 2.0f * floor(0.5f * line)) > 0.5f;
        float wide = (between ? fresh : 2.0f - fresh) * apart * tone;
        cover += stroke_cover(abs(place - line) * apart, wide);
    }
    return min(cover, 1.0f);
}

// Coverage of a pixel where the surface is to have that tone.
float tonal_ink(Surface s, ivec2 pixel, float tone) {
    Place p = place_on(s.plane, pixel);
    vec3 axis = axis_of(s.leaf);
    vec3 side = across_axis(axis);
    vec3 other = cross(axis, side);
    vec3 first = axis;
    // Planes that the surface meets at an angle with the first ones.
    vec3 second = abs(dot(s.normal, other)) >= abs(dot(s.normal, side)) ? 0.5f * axis + 0.8660254f * side
                                                                         : 0.5f * axis + 0.8660254f * other;
    if (abs(dot(s.normal, axis)) > 0.9999f) {
        first = 0.8f * side + 0.6f * other;
        second = 0.6f * side - 0.8f * other;
    }
    // Dark tones are crossed: what both families leave bare is the product of what each does.
    float alone = min(tone, crossed_from);
    float one = alone + 0.4f * (tone - alone);
    float two = 1.0f - (1.0f - tone) / (1.0f - one);
    return 1.0f - (1.0f - stroke_family(p, first, one)) * (1.0f - stroke_family(p, second, two));
}

#include "npr/styles/tonal_ink.glsl"
