// Surface colors with profile and inner edges.
#include "npr/color.glsl"
#include "npr/lines.glsl"
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
    uint lines = layers_near(vec2(pixel), width);
    bool hit = true;
    // Behind the last surface there may still be the outer half of a line that bounds a neighbour's surface.
    for (int i = 0; i < layer_count && through > 0.0 && hit; ++i) {
        Surface s = layer_surface(pixel, i, ray);
        hit = s.hit;
        vec4 c = hit ? surface_color(s) : vec4(0.0);
        c.rgb = mix(vec3(1.0), c.rgb, shade);
        if ((lines >> edge_layer(i) & 1u) != 0u && !(hit && c.a == 0.0)) {
            Edge edge = edge_at(vec2(pixel), i, width);
            c = with_line(c, edge_color, max(edge.profile, inner_strength * edge.inner));
        }
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
