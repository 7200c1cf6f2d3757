// Edges of all layers, with the depth-complexity cue of Nienhaus (2005), 5.2: the tone tells how many surfaces lie
// behind each other, and edges get fainter from layer to layer. Valid in shaders and, within a struct with the same
// names, in C++.

// Coverage by lines one pixel wide, `spacing` pixels apart, in both directions.
float grid_lines(vec2 at, float spacing) {
    vec2 distance = abs(mod(at + 0.5f * spacing, spacing) - 0.5f * spacing);
    vec2 line = clamp(1.0f - distance, 0.0f, 1.0f);
    return max(line.x, line.y);
}

vec4 blueprint(ivec2 pixel) {
    int layers = most_layers > 0 ? min(most_layers, layer_count) : layer_count;
    float clear = 1.0f;
    int seen = 0;
    while (seen < layers && surface_ids(pixel, seen).x != kNoSurface) {
        ++seen;
        clear *= 1.0f - tone;
    }
    float bare = 1.0f;  // of the paper, not yet covered by lines
    float strength = 1.0f;
    if (seen > 0) {
        uvec2 ids = surface_ids(pixel, 0);
        bare -= 0.5f * section_lines(leaf_of(ids), plane_of(ids), pixel);
    }
    for (int i = 0; i < min(layers, kLayersApart) && line_near(i); ++i) {
        bare *= 1.0f - strength * line_ink(i);
        strength = i == 0 ? hidden_strength : strength * hidden_falloff;
    }
    // Strengths are as the eye sees them, hence mixed in sRGB.
    vec3 paper = ground_color;
    if (grid) {
        vec2 at = vec2(pixel) + 0.5f + jitter - 0.5f * vec2(view.picture);
        float line = max(0.5f * grid_lines(at, grid_spacing), grid_lines(at, 5.0f * grid_spacing));
        paper = mix(paper, line_color, 0.12f * line);
    }
    vec3 color = mix(line_color, mix(wash_color, paper, clear), bare);
    float alpha = transparent_background && seen == 0 ? 0.0f : 1.0f;
    return premultiplied(color, alpha);
}
