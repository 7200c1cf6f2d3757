// Surfaces of paper, with ink by tone that a style makes of tonal_ink(surface, pixel, tone), and their lines. Valid in
// shaders and, within a struct with the same names, in C++.
vec4 ink_on_paper(ivec2 pixel) {
    vec3 ray = pixel_ray(pixel);
    Composite seen = nothing_seen();
    while (goes_on(seen, layer_count, 0.0f)) {
        Surface s = layer_surface(pixel, seen.layer, ray);
        vec4 c = vec4(0.0f);
        if (s.hit) {
            c = seen_color(s);
            c = vec4(mix(paper_color, vec3(c), wash), c.a);
        }
        if (c.a > 0.0f) {
            float ink = tonal_ink(s, pixel, ink_tone(rounded(s, pixel), darkest));
            if (is_section(s.leaf))
                ink = section_lines(s.leaf, s.plane, pixel);
            c = vec4(mix(vec3(c), ink_color, ink), c.a);
        }
        if (line_near(seen.layer) && !(s.hit && c.a == 0.0f))
            c = with_line(c, ink_color, line_ink(seen.layer));
        seen = behind(seen, s.hit, c);
    }
    return before_ground(seen.color, seen.through, paper_color);
}
