// The lines of a pixel's layers for styles that look at few of them: `width`, `inner_width` and
// `inner_strength` are settings.
uint layers_with_lines;  // so near that their lines may cover the pixel

void find_visible_lines(ivec2 pixel) {
    layers_with_lines = layers_near(vec2(pixel), width);
}

bool line_near(int layer) {
    return (layers_with_lines >> edge_layer(layer) & 1u) != 0u;
}

Edge line_edge(int layer) {
    return edge_at(floor(gl_FragCoord.xy), layer, width, inner_width, kLight);
}

float line_ink(int layer) {
    Edge edge = line_edge(layer);
    return max(edge.profile, inner_strength * edge.inner);
}
