// n-tone shading with cast shadows and saturation as depth cue, as for illustrative city models (Nienhaus 2005, 4.8). Valid in shaders
// and, within a struct with the same names, in C++.

#include "npr/shadow.glsl"
#include "npr/smooth_normal.glsl"
#include "npr/styles/remoteness.glsl"

// One of `steps` tints of the surface's color: by the angle to the light the darker ones are cooler, too.
vec3 tint_of(vec3 base, Surface s, bool shadowed) {
    float facing = half_lit(0.5f * (dot(mat3(view.eye_from_world) * s.normal, kLightDirection) + 1.0f), shadowed);
    float tone = min(floor(facing * float(steps)), float(steps) - 1.0f) / float(steps - 1);
    return mix(shadow * base * vec3(0.82f, 0.88f, 1.0f), base, tone);
}

// Farther surfaces are less saturated, and as light as they were (Weiskopf and Ertl 2002).
vec3 less_saturated(vec3 c, float part) {
    return mix(c, vec3(dot(c, vec3(0.2126f, 0.7152f, 0.0722f))), part);
}

vec4 ntone(ivec2 pixel) {
    vec3 ray = pixel_ray(pixel);
    Composite seen = nothing_seen();
    Media media = media_at_eye(pixel);
    while (goes_on(seen, layer_count, least_seen())) {
        Surface s = seen_surface(pixel, seen.layer, ray);
        seen = reached(seen, media, s, ray);
        media = beyond(media, s);
        vec4 c = vec4(0.0f);
        if (s.hit)
            c = seen_color(s);
        if (c.a > 0.0f) {
            vec3 tint = less_saturated(tint_of(vec3(c), rounded(s, pixel), in_shadow(pixel, seen.layer)), cue * remoteness(s));
            c = hatched(vec4(tint, c.a), s.leaf, s.plane, pixel);
        }
        if (line_near(seen.layer) && !(s.hit && c.a == 0.0f && !bounds_medium(s)))
            c = with_line(c, edge_color, line_ink(seen.layer));
        seen = behind(seen, s.hit, c);
    }
    return before_background(seen.color, seen.through, pixel);
}
