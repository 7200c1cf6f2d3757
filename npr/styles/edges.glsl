// Surface colors with profile and inner edges. Valid in shaders and, within a struct with the same names, in C++.

#include "npr/smooth_normal.glsl"

vec4 edges(ivec2 pixel) {
    vec3 ray = pixel_ray(pixel);
    Composite seen = nothing_seen();
    Media media = media_at_eye(pixel);
    while (goes_on(seen, layer_count, least_seen())) {
        Surface s = seen_surface(pixel, seen.layer, ray);
        seen = reached(seen, media, s, ray);
        media = beyond(media, s);
        vec4 c = s.hit ? mix(seen_color(s), surface_color(rounded(s, pixel)), light_strength) : vec4(0.0f);
        c = vec4(mix(vec3(1.0f), vec3(c), shade), c.a);
        if (s.hit)
            c = hatched(c, s.leaf, s.plane, pixel);
        if (line_near(seen.layer) && !(s.hit && c.a == 0.0f && !bounds_medium(s)))
            c = with_line(c, s.hit ? line_color_on(edge_color, mix(vec3(1.0f), vec3(seen_color(s)), shade)) : edge_color,
                          line_ink(seen.layer));
        seen = behind(seen, s.hit, c);
    }
    return before_background(seen.color, seen.through, pixel);
}
