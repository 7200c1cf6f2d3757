// A point of an edge on the link between the samples of two neighboring pixels, in 32 bits. Zero: no edge; the larger
// of two counts. Valid in shaders and, within a struct with the same names, in C++.
const uint kInnerEdge = 1u;
const uint kProfileEdge = 2u;
const float kThick = 4.0f;  // pixels; what is as thick as that is not thin

struct EdgePoint {
    uint kind;
    float thickness;  // of what is drawn about, as a share of kThick; of continuations (overshoot.glsl) their strength
    float at;        // part of the way from the link's lower or left pixel
    vec2 across;     // unit vector across the edge, either way
};

EdgePoint edge_point(uint kind, float thickness, float at, vec2 across) {
    EdgePoint e;
    e.kind = kind;
    e.thickness = thickness;
    e.at = at;
    e.across = across;
    return e;
}

uint pack_edge(EdgePoint e) {
    float angle = atan(e.across.y, e.across.x) / 3.14159265f;
    return e.kind << 30 | uint(e.thickness * 1023.0f + 0.5f) << 20 |
           uint(clamp(e.at, 0.0f, 1.0f) * 1023.0f + 0.5f) << 10 | uint(fract(angle) * 1023.99f);
}

EdgePoint unpack_edge(uint bits) {
    float angle = (float(bits & 1023u) + 0.5f) * (3.14159265f / 1024.0f);
    return edge_point(bits >> 30, float(bits >> 20 & 1023u) / 1023.0f, float(bits >> 10 & 1023u) / 1023.0f,
                      vec2(cos(angle), sin(angle)));
}

// The link from a pixel to its right (axis 0) or upper neighbor, in a picture of that width, as one number.
uint link_id(ivec2 lower, int axis, int width) {
    return uint(2 * (lower.y * width + lower.x) + axis);
}

int link_axis(uint link) {
    return int(link & 1u);
}

ivec2 link_lower(uint link, int width) {
    int pixel = int(link >> 1);
    return ivec2(pixel % width, pixel / width);
}

#include "layers/limits.glsl"

int edge_layer(int layer) {
    return min(layer, kLayersApart - 1);
}

// The slice that holds the points of a layer, on links to the right (axis 0) or up.
int edge_slice(int layer, int axis) {
    return 2 * edge_layer(layer) + axis;
}

// A pixel's mark: which layers have an edge on its link.
uint edge_mark(int layer, int axis) {
    return 1u << (edge_layer(layer) + kLayersApart * axis);
}

// Marks are summed up for tiles of this many pixels, squared.
const int kEdgeTile = 4;
