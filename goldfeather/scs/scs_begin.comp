// Begins a product.
#include "goldfeather/scs/scs_pixels.glsl"

void main() {
    ivec2 at;
    if (!find_pixel(at))
        return;
    uint i = pixel_index(at);
    pixels[i].depth = 0xffffffffu;
    pixels[i].limit = 0u;
    pixels[i].entered = 0u;
    pixels[i].mark = 0u;
    pixels[i].leaf = 0xffffffffu;
    pixels[i].plane = 0xffffffffu;
}
