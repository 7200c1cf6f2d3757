// Surfaces compared by their planes only: cheap, for the search where edges may be.
#include "npr/frame.glsl"

layout(local_size_x = 64) in;

uniform bool part_edges;
uniform bool visible_only;  // only edges of what is not hidden

uvec2 surface_ids(ivec2 p, int layer) {
    return layer < layer_count ? texelFetch(layer_surfaces, ivec3(p, layer), 0).xy : uvec2(kNoSurface);
}

// Or no surface at all.
bool same_surface(uvec2 a, uvec2 b) {
    return (a.x == kNoSurface) == (b.x == kNoSurface) && (a.x == kNoSurface || a.y == b.y) &&
           !(part_edges && a.x != kNoSurface && !look_alike(a.x >> 1, b.x >> 1));
}

// Hides everything behind it.
bool opaque(uvec2 ids) {
    return leaf_rows[ids.x >> 1].part.y == kPartSolid && leaf_rows[ids.x >> 1].color.a >= 1.0;
}
