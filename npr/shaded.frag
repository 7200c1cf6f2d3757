// The nearest opaque surface, and translucent ones before it.
#include "npr/color.glsl"
#include "npr/surface_color.glsl"

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
