// The ink of all layers' lines in one pixel.
float ink_of_layers[kLayersApart];
bool lines_near = false;

void find_ink(ivec2 pixel, Pens pens) {
    lines_near = layers_near(vec2(pixel), pens.width) != 0u;
    if (!lines_near)
        return;
    all_edges_at(vec2(pixel), pens, ink_of_layers);
}

bool line_near(int layer) {
    return lines_near && layer < kLayersApart;
}

float line_ink(int layer) {
    return ink_of_layers[layer];
}
