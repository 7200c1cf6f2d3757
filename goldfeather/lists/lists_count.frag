// Counts the surfaces along each pixel's ray.
#include "goldfeather/lists/lists.glsl"

void main() { atomicAdd(pixel_lists[pixel_index(ivec2(gl_FragCoord.xy))].count, 1u); }
