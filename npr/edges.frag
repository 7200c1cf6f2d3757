// Surface colors with profile and inner edges.
#include "npr/color.glsl"
#include "npr/edges.glsl"
#include "npr/surface_color.glsl"

uniform float width;
uniform float inner_strength;
uniform vec3 edge_color;
uniform float shade;  // 0: paper, 1: surface colors
out vec4 result;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 ray = pixel_ray(pixel);
    vec3 color = vec3(0.0);  // premultiplied
    float through = 1.0;
    for (int i = 0; i < layer_count && through > 0.0; ++i) {
        Surface s = layer_surface(pixel, i, ray);
        if (!s.hit)
            break;
        vec4 c = surface_color(s);
        if (c.a == 0.0)
            continue;
        c.rgb = mix(vec3(1.0), c.rgb, shade);
        Edge edge = surface_edge(s, pixel, width);
        float ink = max(edge.profile, inner_strength * edge.inner);
        c = mix(c, vec4(edge_color, 1.0), ink);
        color += through * c.a * c.rgb;
        through *= 1.0 - c.a;
    }
    if (!transparent_background) {
        color += through * background(pixel);
        through = 0.0;
    }
    float alpha = 1.0 - through;
    result = premultiplied(color / max(alpha, 1e-6), alpha);
}
