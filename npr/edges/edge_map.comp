// Finds the edges of the listed surfaces on their links (npr/edges/edge_map.h). Profile edges win over inner edges.
#include "npr/edges/edge_point.glsl"
#include "npr/frame.glsl"

uniform float crease_angle;  // between normals, from which a bend is an inner edge
uniform bool part_edges;     // boundaries of parts and colors on smooth surfaces are inner edges
uniform bool follow_borders;

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Candidates {
    uint candidate_count;
    uint candidate_room;
    uvec2 candidates[];
};
layout(r32ui, binding = 0) uniform uimage2DArray edge_points;
layout(r32ui, binding = 1) uniform uimage2D edge_marks;
layout(r32ui, binding = 2) uniform uimage2D edge_tiles;

layout(std430, binding = 10) readonly buffer SmoothGroups { uint group_words[]; };  // layers/smooth_groups.glsl

#include "npr/plane_lookup.glsl"
#include "npr/planes.glsl"

#include "npr/edges/creases.glsl"

#include "npr/edges/continuation_at.glsl"

#include "npr/edges/contour.glsl"

#include "npr/edges/edge_rules.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= min(candidate_count, candidate_room))
        return;
    int axis = link_axis(candidates[i].x);
    ivec2 lower = link_lower(candidates[i].x, textureSize(layer_depths, 0).x);
    bool upper = (candidates[i].y & 1u) != 0u;
    ivec2 offset = ivec2(1 - axis, axis);
    FoundEdge e = edge_of(int(candidates[i].y >> 1), upper ? lower + offset : lower, upper ? -offset : offset);
    if (!e.found)
        return;
    if (upper)
        e.point.at = 1.0 - e.point.at;
    imageAtomicMax(edge_points, ivec3(lower, edge_slice(e.layer, axis)), pack_edge(e.point));
    uint mark = edge_mark(e.layer, axis);
    imageAtomicOr(edge_marks, lower, mark);
    imageAtomicOr(edge_tiles, lower / kEdgeTile, mark);
}
