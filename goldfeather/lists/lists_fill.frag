// Writes the surfaces along each pixel's ray to its list, in no order.
#include "goldfeather/surface_depth.glsl"
#include "goldfeather/lists/lists.glsl"

flat in uint triangle;

uniform uint entry_capacity;

void main() {
    uint at = atomicAdd(pixel_lists[pixel_index(ivec2(gl_FragCoord.xy))].next, 1u);
    // That a list holds just what was counted is checked when it is resolved.
    if (at < entry_capacity)
        entries[at] = uvec2(floatBitsToUint(surface_depth()), triangle | (gl_FrontFacing ? 0u : kFromBehind));
}
