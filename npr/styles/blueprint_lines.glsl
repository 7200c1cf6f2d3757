// Blueprints of lines alone (Nienhaus 2005, 5.2): of the edges of all layers those are drawn whose intensity is above a
// threshold, all as dark as each other, which looks like a drawing of wires. Deeper edges are fainter, and so thinner,
// until they are left out. Valid in shaders and, within a struct with the same names, in C++.

const float kSoftThreshold = 0.5f;  // of ink, over which lines begin

vec4 blueprint_lines(ivec2 pixel) {
    int layers = most_layers > 0 ? min(most_layers, layer_count) : layer_count;
    float ink = 0.0f;
    float strength = 1.0f;
    bool seen = surface_ids(pixel, 0).x != kNoSurface;
    if (seen) {
        uvec2 ids = surface_ids(pixel, 0);
        ink = 0.5f * section_lines(leaf_of(ids), plane_of(ids), pixel);
    }
    for (int i = 0; i < min(layers, kLayersApart) && line_near(i); ++i) {
        float above = strength * line_ink(i) - threshold;
        ink = max(ink, clamp(0.5f + above / kSoftThreshold, 0.0f, 1.0f));
        strength *= hidden_falloff;
    }
    // Strengths are as the eye sees them, hence mixed in sRGB.
    return premultiplied(mix(paper_color, ink_color, ink), transparent_background && !seen ? ink : 1.0f);
}
