// Lists the surfaces that do not go on in their own plane at the other end of the listed links: where edges may be.
#include "npr/edges/edge_point.glsl"
#include "npr/frame.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 2) readonly buffer Links {
    uint link_count;
    uint links[];
};
layout(std430, binding = 3) buffer Candidates {
    uint candidate_count;
    uint candidate_room;
    uvec2 candidates[];  // link; layer << 1 | (1: of the link's upper or right end)
};
layout(r32ui, binding = 0) writeonly uniform uimage2DArray edge_points;

uniform bool part_edges;
uniform bool visible_only;  // only edges of what is not hidden
uniform float crease_angle;

void add(uint link, int layer, uint end) {
    uint at = atomicAdd(candidate_count, 1u);
    if (at < candidate_room)
        candidates[at] = uvec2(link, uint(layer) << 1 | end);
}

layout(std430, binding = 10) readonly buffer SmoothGroups { uint group_words[]; };  // layers/smooth_groups.glsl

#include "npr/plane_lookup.glsl"
#include "npr/planes.glsl"

#include "npr/edges/creases.glsl"
#include "npr/edges/same_surface.glsl"

#include "npr/edges/edge_search.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= link_count)
        return;
    int axis = link_axis(links[i]);
    ivec2 p = link_lower(links[i], textureSize(layer_depths, 0).x);
    int last = search_link(links[i], p, p + ivec2(1 - axis, axis));
    for (int layer = 0; layer <= min(last, kLayersApart - 1); ++layer)
        imageStore(edge_points, ivec3(p, edge_slice(layer, axis)), uvec4(0u));
}
