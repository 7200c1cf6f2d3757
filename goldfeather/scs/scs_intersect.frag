// Intersects convex leaves: all are entered at the farthest of their fronts, and one is left at the nearest of their
// backs.
#include "goldfeather/surface_depth.glsl"
#include "goldfeather/scs/scs.glsl"

void main() {
    uint i = pixel_index(ivec2(gl_FragCoord.xy));
    uint depth = floatBitsToUint(surface_depth());
    if (gl_FrontFacing) {
        atomicMin(pixels[i].depth, depth);
        atomicAdd(pixels[i].entered, 1u);
    } else {
        atomicMax(pixels[i].limit, depth);
    }
}
