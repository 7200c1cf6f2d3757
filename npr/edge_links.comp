// Lists the links between neighbouring pixels that do not see the same planes. Most do.
#include "npr/edge_search.glsl"

layout(std430, binding = 2) buffer Links {
    uint link_count;
    uint links[];
};

void main() {
    ivec2 size = textureSize(layer_depths, 0).xy;
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (p.x >= size.x)
        return;
    for (int axis = 0; axis < 2; ++axis) {
        ivec2 q = p + ivec2(1 - axis, axis);
        if (q.x >= size.x || q.y >= size.y)
            continue;
        uvec2 a, b;
        int i = 0;
        do {
            a = surface_ids(p, i);
            b = surface_ids(q, i);
            ++i;
        } while (a.x != kNone && same_surface(a, b) && !(visible_only && opaque(a)));
        if (!same_surface(a, b))
            links[atomicAdd(link_count, 1u)] = link_id(p, axis);
    }
}
