// Cool-to-warm shading for technical illustrations, with inner edges and profile edges in colors of their own (Gooch et
// al. 1998; Nienhaus 2005, listing 3-2). Valid in shaders and, within a struct with the same names, in C++.

#include "npr/shadow.glsl"
#include "npr/smooth_normal.glsl"
#include "npr/styles/gooch_light.glsl"

vec4 gooch(ivec2 pixel) {
    vec3 ray = pixel_ray(pixel);
    vec3 direction = mat3(view.eye_from_world) * normalize(ray);
    Composite seen = nothing_seen();
    Media media = media_at_eye(pixel);
    while (goes_on(seen, layer_count, least_seen())) {
        Surface s = seen_surface(pixel, seen.layer, ray);
        seen = reached(seen, media, s, ray);
        media = beyond(media, s);
        vec4 c = vec4(0.0f);
        if (s.hit) {
            vec4 base = seen_color(s);
            c = hatched(vec4(gooch_color(vec3(base), rounded(s, pixel), direction, in_shadow(pixel, seen.layer)), base.a), s.leaf, s.plane, pixel);
        }
        if (line_near(seen.layer) && !(s.hit && c.a == 0.0f && !bounds_medium(s))) {
            Edge edge = line_edge(seen.layer);
            c = with_line(c, inner_color, inner_strength * edge.inner);
            c = with_line(c, profile_color, edge.profile);
        }
        seen = behind(seen, s.hit, c);
    }
    return before_background(seen.color, seen.through, pixel);
}
