// Lists the links between neighboring pixels that do not see the same planes. Most do.
#include "npr/edges/edge_point.glsl"
#include "npr/frame.glsl"

layout(local_size_x = 64) in;

uniform bool part_edges;
uniform bool visible_only;  // only edges of what is not hidden

#include "npr/edges/same_surface.glsl"

layout(std430, binding = 2) buffer Links {
    uint link_count;
    uint links[];
};

void main() {
    ivec2 size = textureSize(layer_depths, 0).xy;
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (p.x >= size.x)
        return;
    // Both links at once, as they share an end.
    bvec2 open = bvec2(p.x + 1 < size.x, p.y + 1 < size.y), differs = bvec2(false);
    for (int i = 0; any(open); ++i) {
        uvec2 a = surface_ids(p, i);
        bool last = a.x == kNoSurface || (visible_only && opaque(a));
        for (int axis = 0; axis < 2; ++axis) {
            if (!open[axis])
                continue;
            differs[axis] = !same_surface(a, surface_ids(p + ivec2(1 - axis, axis), i));
            open[axis] = !last && !differs[axis];
        }
    }
    for (int axis = 0; axis < 2; ++axis)
        if (differs[axis])
            links[atomicAdd(link_count, 1u)] = link_id(p, axis, size.x);
}
