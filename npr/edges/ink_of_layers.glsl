// The ink of all layers' lines in one pixel.
float ink_of_layers[kLayersApart];
bool lines_near = false;

void find_ink(ivec2 pixel, float width, float hidden_width, float profile_strength, float inner_strength) {
    lines_near = layers_near(vec2(pixel), width) != 0u;
    if (!lines_near)
        return;
    all_edges_at(vec2(pixel), Pens(width, hidden_width, profile_strength, inner_strength), ink_of_layers);
}

bool line_near(int layer) {
    return lines_near && layer < kLayersApart;
}

float line_ink(int layer) {
    return ink_of_layers[layer];
}
