#include "npr/frame.glsl"
#include "npr/edges/lines.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 2) readonly buffer Links {
    uint link_count;
    uint links[];
};
layout(r32ui, binding = 0) uniform uimage2DArray beyond_points;
layout(r32ui, binding = 1) uniform uimage2D beyond_tiles;

uniform float overshoot;  // pixels

EdgePoint visible_edge(ivec2 lower, int axis) {
    bool marked = (texelFetch(edge_marks, lower, 0).x & edge_mark(0, axis)) != 0u;
    return unpack_edge(marked ? texelFetch(edge_points, ivec3(lower, axis), 0).x : 0u);
}

void draw_beyond(ivec2 lower, int axis, EdgePoint e) {
    imageAtomicMax(beyond_points, ivec3(lower, axis), pack_edge(e));
    imageAtomicOr(beyond_tiles, lower / kEdgeTile, 1u);
}

#include "npr/edges/overshoot.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < link_count)
        draw_on_link(link_lower(links[i], picture_size().x), link_axis(links[i]));
}
