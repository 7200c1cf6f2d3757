// Edge-enhanced transparency (Nienhaus 2005, 5.3): surface color times edge intensity, layer by layer, front to back.
#include "npr/color.glsl"
#include "npr/lines.glsl"
#include "npr/surface_color.glsl"

uniform float width;
uniform float opacity;  // of a layer that faces the eye
uniform float rim;
uniform float profile_strength;
uniform float inner_strength;
uniform float falloff;
uniform float cue;
uniform int colors;       // 0: of the model, 1: by layer, 2: none
uniform int most_layers;  // 0: all
out vec4 result;

vec4 layer_color(Surface s, int layer) {
    vec4 model = base_color(s);
    if (colors == 1)
        return vec4(0.62 + 0.33 * cos(2.4 * float(layer) + vec3(2.6, 4.4, 0.6)), model.a);
    if (colors == 2)
        return vec4(vec3(0.72), model.a);
    return model;
}

// 0 at the near end of the scene, 1 at the far end.
float remoteness(Surface s) {
    return clamp(0.5 + (view_distance(s.depth) + centre_in_eye.z) / view.depth_range.w, 0.0, 1.0);
}

// A thin wall is crossed on a longer way where it is seen at a slant.
float wall_opacity(Surface s, vec3 ray) {
    float facing = max(abs(dot(s.normal, normalize(ray))), 0.05);
    return 1.0 - pow(1.0 - opacity, pow(facing, -rim));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 ray = pixel_ray(pixel);
    int layers = most_layers > 0 ? min(most_layers, layer_count) : layer_count;
    float lines[kEdgeLayers];
    bool near = layers_near(vec2(pixel), width) != 0u;
    if (near)
        all_edges_at(vec2(pixel), width, width, profile_strength, inner_strength, lines);
    vec3 color = vec3(0.0);  // premultiplied
    float through = 1.0;
    float strength = 1.0;
    vec3 ink = vec3(0.12);
    bool hit = true;
    // Behind the last surface there may still be the outer half of a line that bounds a neighbour's surface.
    for (int i = 0; i < layers && hit && through > 0.004; ++i) {
        Surface s = layer_surface(pixel, i, ray);
        hit = s.hit;
        vec4 c = vec4(0.0);
        float fog = 0.0;
        if (hit) {
            vec4 base = layer_color(s, i);
            fog = cue * remoteness(s);
            ink = 0.22 * base.rgb;
            c.rgb = mix(min(base.rgb * light(s.normal), 1.0), background_color, fog);
            c.a = base.a * wall_opacity(s, ray);
        }
        if (near && i < kEdgeLayers)
            c = with_line(c, ink, strength * (1.0 - fog) * lines[i]);
        color += through * c.a * c.rgb;
        through *= 1.0 - c.a;
        strength *= falloff;
    }
    if (!transparent_background) {
        color += through * background(pixel);
        through = 0.0;
    }
    float alpha = 1.0 - through;
    result = premultiplied(color / max(alpha, 1e-6), alpha);
}
