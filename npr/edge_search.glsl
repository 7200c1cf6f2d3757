// Surfaces compared by their planes only: cheap, for the search where edges may be.
#include "npr/frame.glsl"

layout(local_size_x = 64) in;

uniform bool part_edges;
uniform bool visible_only;  // only edges of what is not hidden

const uint kNone = 0xffffffffu;

uvec2 surface_ids(ivec2 p, int layer) {
    return layer < layer_count ? texelFetch(layer_surfaces, ivec3(p, layer), 0).xy : uvec2(kNone);
}

// Or no surface at all.
bool same_surface(uvec2 a, uvec2 b) {
    return (a.x == kNone) == (b.x == kNone) && (a.x == kNone || a.y == b.y) &&
           !(part_edges && a.x != kNone && !look_alike(a.x >> 1, b.x >> 1));
}

// Hides everything behind it.
bool opaque(uvec2 ids) {
    return leaf_rows[ids.x >> 1].part.y == kPartSolid && leaf_rows[ids.x >> 1].color.a >= 1.0;
}

// The link from a pixel to its right (axis 0) or upper neighbour.
uint link_id(ivec2 lower, int axis) {
    return uint(2 * (lower.y * textureSize(layer_depths, 0).x + lower.x) + axis);
}
