// Where the leaf has begun and not ended at the depth, the product is true behind the leaf at the earliest. A query
// counts the pixels that move.
#include "goldfeather/surface_depth.glsl"
#include "goldfeather/scs/scs.glsl"

uniform uint pass;

void main() {
    uint i = pixel_index(ivec2(gl_FragCoord.xy));
    uint depth = floatBitsToUint(surface_depth());
    if (gl_FrontFacing || pixels[i].mark != pass || depth >= pixels[i].depth)
        discard;
    pixels[i].depth = depth;
}
