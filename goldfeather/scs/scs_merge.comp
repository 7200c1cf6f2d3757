// Takes the product over where it is true before all others; where several begin at one depth the smallest leaf counts.
#include "goldfeather/scs/scs_pixels.glsl"

void main() {
    ivec2 at;
    if (!find_pixel(at))
        return;
    uint i = pixel_index(at);
    ScsPixel pixel = pixels[i];
    if (!is_alive(pixel) || pixel.depth < pixel.best_depth)
        return;
    bool nearer = pixel.depth > pixel.best_depth;
    pixels[i].best_depth = pixel.depth;
    pixels[i].best_leaf = nearer ? pixel.leaf : min(pixel.leaf, pixel.best_leaf);
    pixels[i].best_plane = nearer ? pixel.plane : min(pixel.plane, pixel.best_plane);
}
