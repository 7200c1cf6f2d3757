// Edge-enhanced transparency with Gooch's light (Nienhaus 2005, 5.3): each layer is colored by it, times what its edges
// leave, and laid over the next. Valid in shaders and, within a struct with the same names, in C++.

#include "npr/smooth_normal.glsl"
#include "npr/styles/gooch_light.glsl"

vec4 tech(ivec2 pixel) {
    vec3 ray = pixel_ray(pixel);
    vec3 direction = mat3(view.eye_from_world) * normalize(ray);
    int layers = most_layers > 0 ? min(most_layers, layer_count) : layer_count;
    Composite seen = nothing_seen();
    float strength = 1.0f;
    while (goes_on(seen, layers, 0.008f)) {
        Surface s = layer_surface(pixel, seen.layer, ray);
        vec4 c = vec4(0.0f);
        if (s.hit) {
            vec4 base = base_color(s);
            c = hatched(vec4(gooch_color(vec3(base), rounded(s, pixel), direction, false), base.a * opacity), s.leaf, s.plane, pixel);
        }
        if (line_near(seen.layer))
            c = with_line(c, edge_color, strength * line_ink(seen.layer));
        seen = behind(seen, s.hit, c);
        strength *= falloff;
    }
    return before_background(seen.color, seen.through, pixel);
}
