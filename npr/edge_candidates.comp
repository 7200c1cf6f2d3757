// Lists the surfaces that do not go on in their own plane at the other end of the listed links: where edges may be.
#include "npr/edge_point.glsl"
#include "npr/edge_search.glsl"

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

// Returns how many surfaces `p` has.
int search(ivec2 p, ivec2 q, uint link, uint end) {
    int i = 0;
    for (; i < layer_count; ++i) {
        uvec2 a = surface_ids(p, i);
        if (a.x == kNone)
            break;
        bool found = same_surface(a, surface_ids(q, i));
        for (int j = 0; j < layer_count && !found; ++j) {
            uvec2 b = surface_ids(q, j);
            if (b.x == kNone)
                break;
            found = same_surface(a, b);
        }
        if (!found) {
            uint at = atomicAdd(candidate_count, 1u);
            if (at < candidate_room)
                candidates[at] = uvec2(link, uint(i) << 1 | end);
        }
    }
    return i;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= link_count)
        return;
    int width = textureSize(layer_depths, 0).x;
    int pixel = int(links[i] >> 1);
    int axis = int(links[i] & 1u);
    ivec2 lower = ivec2(pixel % width, pixel / width);
    ivec2 offset = ivec2(1 - axis, axis);
    int layers = 0;
    for (uint end = 0u; end < 2u; ++end) {
        ivec2 p = end == 0u ? lower : lower + offset;
        layers = max(layers, search(p, end == 0u ? lower + offset : lower, links[i], end));
    }
    for (int layer = 0; layer < min(layers, kEdgeLayers); ++layer)
        imageStore(edge_points, ivec3(lower, edge_slice(layer, axis)), uvec4(0u));
}
