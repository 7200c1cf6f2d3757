// Surface colors with profile and inner edges. Valid in shaders and, within a struct with the same names, in C++.
vec4 edges(ivec2 pixel) {
    vec3 ray = pixel_ray(pixel);
    vec3 color = vec3(0.0f);  // premultiplied
    float through = 1.0f;
    bool hit = true;
    // Behind the last surface there may still be the outer half of a line that bounds a neighbour's surface.
    for (int i = 0; i < layer_count && through > 0.0f && hit; ++i) {
        Surface s = layer_surface(pixel, i, ray);
        hit = s.hit;
        vec4 c = hit ? mix(seen_color(s), surface_color(s), light_strength) : vec4(0.0f);
        c = vec4(mix(vec3(1.0f), vec3(c), shade), c.a);
        if (line_near(i) && !(hit && c.a == 0.0f))
            c = with_line(c, edge_color, line_ink(i));
        color += through * c.a * vec3(c);
        through *= 1.0f - c.a;
    }
    return before_background(color, through, pixel);
}
