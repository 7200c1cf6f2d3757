// What the lines along the edges of the map are (npr/edges/line_facts.glsl): after npr/edges/edge_map.comp, for the edge
// that won on each link and layer.
#include "npr/edges/edge_point.glsl"
#include "npr/edges/line_facts.glsl"
#include "npr/frame.glsl"

uniform float crease_angle;
uniform bool part_edges;
uniform bool follow_borders;
uniform bool clearances;  // are they wanted?
uniform bool clearing;  // the first of two passes

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Candidates {
    uint candidate_count;
    uint candidate_room;
    uvec2 candidates[];
};
layout(r32ui, binding = 0) readonly uniform uimage2DArray edge_points;
layout(r32ui, binding = 1) uniform uimage2DArray edge_facts;  // two slices for each of the points'

layout(std430, binding = 10) readonly buffer SmoothGroups { uint group_words[]; };  // layers/smooth_groups.glsl

#include "npr/plane_lookup.glsl"
#include "npr/planes.glsl"

#include "npr/edges/creases.glsl"

#include "npr/edges/continuation_at.glsl"

#include "npr/edges/contour.glsl"

#include "npr/edges/edge_rules.glsl"

#include "npr/edges/line_rules.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= min(candidate_count, candidate_room))
        return;
    int axis = link_axis(candidates[i].x);
    ivec2 lower = link_lower(candidates[i].x, textureSize(layer_depths, 0).x);
    bool upper = (candidates[i].y & 1u) != 0u;
    ivec2 offset = ivec2(1 - axis, axis);
    ivec2 p = upper ? lower + offset : lower;
    int layer = int(candidates[i].y >> 1);
    ivec2 onward = upper ? -offset : offset;
    FoundEdge e = edge_of(layer, p, onward);
    if (!e.found)
        return;
    ivec3 place = ivec3(lower, edge_slice(e.layer, axis));
    EdgePoint kept = e.point;
    if (upper)
        kept.at = 1.0 - kept.at;
    if (imageLoad(edge_points, place).x != pack_edge(kept))
        return;
    ivec3 first = ivec3(place.xy, 2 * place.z), second = first + ivec3(0, 0, 1);
    if (clearing) {
        imageStore(edge_facts, first, uvec4(0u));
        imageStore(edge_facts, second, uvec4(0u));
        return;
    }
    // Where edges found from both ends of a link are one to the last bit, so are their facts, most likely; the larger
    // words are kept, in whatever order they come.
    uvec2 words = pack_facts(line_facts(layer, p, onward, e));
    imageAtomicMax(edge_facts, first, words.x);
    imageAtomicMax(edge_facts, second, words.y);
}
