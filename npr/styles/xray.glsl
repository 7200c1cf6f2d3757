// Edge-enhanced transparency (Nienhaus 2005, 5.3): surface color times edge intensity, layer by layer, front to back.
// Valid in shaders and, within a struct with the same names, in C++.

vec4 layer_color(Surface s, int layer) {
    vec4 model = base_color(s);
    if (colors == 1)
        return vec4(0.62f + 0.33f * cos(2.4f * float(layer) + vec3(2.6f, 4.4f, 0.6f)), model.a);
    if (colors == 2)
        return vec4(vec3(0.72f), model.a);
    return model;
}

#include "npr/smooth_normal.glsl"
#include "npr/styles/remoteness.glsl"

// A thin wall is crossed on a longer way where it is seen at a slant. `direction`: unit vector; `absorption`: the binary
// logarithm of what a wall lets through that faces the eye.
float wall_opacity(Surface s, vec3 direction, float absorption) {
    float facing = max(abs(dot(s.normal, direction)), 0.05f);
    return 1.0f - exp2(absorption * pow(facing, -rim));
}

vec4 xray(ivec2 pixel) {
    vec3 ray = pixel_ray(pixel);
    vec3 direction = normalize(ray);
    int layers = most_layers > 0 ? min(most_layers, layer_count) : layer_count;
    Composite seen = nothing_seen();
    float strength = 1.0f;
    float absorption = log2(max(1.0f - opacity, 1e-30f));
    vec3 ink = vec3(0.12f);
    while (goes_on(seen, layers, 0.004f)) {
        Surface s = layer_surface(pixel, seen.layer, ray);
        vec4 c = vec4(0.0f);
        float fog = 0.0f;
        if (s.hit) {
            vec4 base = layer_color(s, seen.layer);
            fog = cue * remoteness(s);
            ink = 0.22f * vec3(base);
            s = rounded(s, pixel);
            c = vec4(mix(min(vec3(base) * light(s.normal), 1.0f), background_color, fog),
                     base.a * wall_opacity(s, direction, absorption));
            c = hatched(c, s.leaf, s.plane, pixel);
        }
        if (line_near(seen.layer))
            c = with_line(c, ink, strength * (1.0f - fog) * line_ink(seen.layer));
        seen = behind(seen, s.hit, c);
        strength *= falloff;
    }
    return before_background(seen.color, seen.through, pixel);
}
