// Lists the surfaces that do not go on in their own plane at the other end of the listed links: where edges may be.
#include "npr/edge_point.glsl"
#include "npr/edge_search.glsl"
#include "npr/planes.glsl"

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

uniform float crease_cosine;

uint bit_of(uvec2 ids) {
    return 1u << (ids.y * 2654435769u >> 27);
}

// The surfaces of a pixel, one bit each; different ones may share a bit.
uint surface_bits(ivec2 p) {
    uint bits = 0u;
    for (int i = 0; i < layer_count; ++i) {
        uvec2 ids = surface_ids(p, i);
        if (ids.x == kNoSurface)
            break;
        bits |= bit_of(ids);
    }
    return bits;
}

bool in_pixel(uvec2 a, ivec2 q, uint bits) {
    if ((bits & bit_of(a)) == 0u)
        return false;
    for (int j = 0; j < layer_count; ++j) {
        uvec2 b = surface_ids(q, j);
        if (b.x == kNoSurface)
            return false;
        if (same_surface(a, b))
            return true;
    }
    return false;
}

void add(uint link, int layer, uint end) {
    uint at = atomicAdd(candidate_count, 1u);
    if (at < candidate_room)
        candidates[at] = uvec2(link, uint(layer) << 1 | end);
}

// Two neighbouring facets of a curved surface, most often: no edge.
bool smooth_joint(ivec2 p, ivec2 q, int layer) {
    Surface s = layer_surface(p, layer, pixel_ray(p)), t = layer_surface(q, layer, pixel_ray(q));
    float cosine = dot(s.normal, t.normal);
    float here, there;
    return s.leaving == t.leaving && cosine > crease_cosine && !(part_edges && !look_alike(s.leaf, t.leaf)) &&
           meet(s, depth_gradient(s.plane), t, depth_gradient(t.plane), q - p, cosine, here, there);
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= link_count)
        return;
    uint link = links[i];
    int axis = link_axis(link);
    ivec2 p = link_lower(link, textureSize(layer_depths, 0).x);
    ivec2 q = p + ivec2(1 - axis, axis);
    uint p_bits = surface_bits(p), q_bits = surface_bits(q);
    bool p_ahead = true, q_ahead = true;
    int last = -1;  // of the candidates
    for (int layer = 0; layer < layer_count; ++layer) {
        uvec2 a = p_ahead ? surface_ids(p, layer) : uvec2(kNoSurface);
        uvec2 b = q_ahead ? surface_ids(q, layer) : uvec2(kNoSurface);
        p_ahead = a.x != kNoSurface && !(visible_only && opaque(a));
        q_ahead = b.x != kNoSurface && !(visible_only && opaque(b));
        if (a.x == kNoSurface && b.x == kNoSurface)
            break;
        if (a.x != kNoSurface && b.x != kNoSurface && same_surface(a, b))
            continue;
        bool a_ends = a.x != kNoSurface && !in_pixel(a, q, q_bits);
        bool b_ends = b.x != kNoSurface && !in_pixel(b, p, p_bits);
        if (a_ends && b_ends && smooth_joint(p, q, layer))
            continue;
        if (a_ends)
            add(link, layer, 0u);
        if (b_ends)
            add(link, layer, 1u);
        if (a_ends || b_ends)
            last = layer;
    }
    for (int i = 0; i <= min(last, kEdgeLayers - 1); ++i)
        imageStore(edge_points, ivec3(p, edge_slice(i, axis)), uvec4(0u));
}
