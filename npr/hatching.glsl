// Tone by hatching: pencil strokes side by side, in a direction for each main direction of the surface.
#include "npr/frame.glsl"
#include "npr/noise.glsl"

uniform float unit;  // pixels in a 512th of the picture's height
uniform uint seed;

// One light from the upper left; surfaces that turn away from it get no light at all.
float sketch_light(Surface s) {
    vec3 n = mat3(view.eye_from_world) * s.normal;
    float direct = dot(n, normalize(vec3(-0.55, 0.65, 0.5)));
    return clamp(0.2 + 0.45 * direct + 0.35 * n.z, 0.0, 1.0);
}

// A family of parallel strokes: coverage of `at` (pixels). `weight` from 0 to 1 thins and thickens them.
float stroke_family(vec2 at, float angle, float spacing, float weight, uint family) {
    vec2 along = vec2(cos(angle), sin(angle));
    float v = dot(at, along);
    float u = dot(at, vec2(-along.y, along.x)) / spacing;
    float line = floor(u);
    vec3 own = white_noise(ivec2(int(line), int(family)), seed);
    // Strokes of uneven length and place, each a little lighter at its ends.
    float length = spacing * (9.0 + 9.0 * own.x);
    float part = fract(v / length + own.y);
    float ends = smoothstep(0.0, 0.16, part) * smoothstep(1.0, 0.8, part);
    float beside = abs(fract(u) - 0.5 + 0.3 * (own.z - 0.5)) * spacing;
    float thick = (0.3 + 0.9 * weight) * max(0.55 * unit, 0.7);
    return clamp(0.5 * thick + 0.5 - beside, 0.0, 1.0) * ends * min(1.0, 0.35 + weight);
}

// `shadow` from 0 (paper) to 1.
float hatching(vec2 at, vec3 normal, float shadow) {
    vec3 w = normal * normal;
    w *= w;
    w /= w.x + w.y + w.z;
    float spacing = 4.2 * unit;
    float ink = 0.0;
    const float angles[3] = float[3](1.95, 0.96, 0.3);
    for (uint k = 0u; k < 3u; ++k) {
        float share = smoothstep(0.15, 0.5, w[k]);
        float weight = share * smoothstep(0.28, 0.9, shadow);
        if (weight > 0.02)
            ink = max(ink, weight * stroke_family(at, angles[k], spacing, weight, k));
    }
    // Crossed where it is darkest.
    float dark = smoothstep(0.62, 0.95, shadow);
    if (dark > 0.02)
        ink = max(ink, dark * stroke_family(at, 2.5, 1.15 * spacing, dark, 3u));
    return ink;
}
