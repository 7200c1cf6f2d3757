// Marks pixels where a subtracted leaf has begun at the depth.
#include "goldfeather/surface_depth.glsl"
#include "goldfeather/scs/scs.glsl"

uniform uint pass;

void main() {
    uint i = pixel_index(ivec2(gl_FragCoord.xy));
    if (gl_FrontFacing && is_alive(pixels[i]) && floatBitsToUint(surface_depth()) >= pixels[i].depth)
        pixels[i].mark = pass;
    discard;  // not counted as moving
}
