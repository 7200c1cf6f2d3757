// Finds whose surface is at the depth: the smallest leaf's. What is subtracted ends there, what is intersected begins.
#include "goldfeather/surface_depth.glsl"
#include "goldfeather/scs/scs.glsl"
#include "goldfeather/triangles.glsl"
#include "layers/surface_ids.glsl"

flat in uint plane;
flat in uint triangle;

layout(std430, binding = 8) readonly buffer Triangles { TriangleRow triangles[]; };

void main() {
    uint i = pixel_index(ivec2(gl_FragCoord.xy));
    if (!is_alive(pixels[i]) || floatBitsToUint(surface_depth()) != pixels[i].depth)
        return;
    atomicMin(pixels[i].leaf, leaf_word(triangles[triangle].leaf, !gl_FrontFacing));
    atomicMin(pixels[i].plane, plane);
}
