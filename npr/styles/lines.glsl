// Line drawings with hidden lines removed: surfaces are paper. Valid in shaders and, within a struct with the same
// names, in C++.
vec4 line_drawing(ivec2 pixel) {
    vec3 ray = pixel_ray(pixel);
    Composite seen = nothing_seen();
    while (goes_on(seen, layer_count, 0.0f)) {
        Surface s = layer_surface(pixel, seen.layer, ray);
        vec4 c = vec4(0.0f);
        if (s.hit) {
            c = vec4(paper_color, seen_color(s).a);
            c = vec4(mix(paper_color, ink_color, 0.6f * section_lines(s.leaf, s.plane, pixel)), c.a);
        }
        if (line_near(seen.layer) && !(s.hit && c.a == 0.0f))
            c = with_line(c, ink_color, line_ink(seen.layer));
        seen = behind(seen, s.hit, c);
    }
    return before_ground(seen.color, seen.through, paper_color);
}
