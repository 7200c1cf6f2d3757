// The nearest opaque surface, and translucent ones before it. Valid in shaders and, within a struct with the same
// names, in C++.
vec4 shaded(ivec2 pixel) {
    vec3 ray = pixel_ray(pixel);
    vec3 color = vec3(0.0f);  // premultiplied
    float through = 1.0f;
    for (int i = 0; i < layer_count && through > 0.0f; ++i) {
        Surface s = layer_surface(pixel, i, ray);
        if (!s.hit)
            break;
        vec4 c = surface_color(s);
        color += through * c.a * vec3(c);
        through *= 1.0f - c.a;
    }
    return before_background(color, through, pixel);
}
