// Bands of equal distance from the eye. Valid in shaders and, within a struct with the same names, in C++.
vec4 bands(ivec2 pixel) {
    Surface s = layer_surface(pixel, 0, pixel_ray(pixel));
    vec3 color = fract(view_distance(s.depth) / spacing) < 0.5f ? ink : vec3(base_color(s));
    return s.hit ? premultiplied(color, 1.0f) : before_background(vec3(0.0f), 1.0f, pixel);
}
