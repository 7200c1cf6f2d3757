// Stores the layer.
#include "goldfeather/scs/scs_pixels.glsl"
#include "layers/surface_ids.glsl"

layout(r32f, binding = 0) writeonly uniform image2DArray layer_depths;
layout(rg32ui, binding = 1) writeonly uniform uimage2DArray layer_surfaces;

uniform int first_row;

void main() {
    ivec2 at;
    if (!find_pixel(at))
        return;
    ScsPixel pixel = pixels[pixel_index(at)];
    if (pixel.best_depth == 0u)
        return;
    ivec3 to = ivec3(at.x, at.y + first_row, 0);
    imageStore(layer_depths, to, vec4(uintBitsToFloat(pixel.best_depth)));
    imageStore(layer_surfaces, to, uvec4(pixel.best_leaf, plane_word(pixel.best_plane, false), 0u, 0u));
}
