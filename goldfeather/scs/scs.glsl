// Per-pixel state of sequenced convex subtraction: goldfeather/scs/scs.h. Depths are bits of reversed depths, which are
// ordered as the depths are; 0: none.
struct ScsPixel {
    uint depth;       // of the product at hand: where it is true first, as far as leaves have been subtracted
    uint limit;       // where the first of its intersected leaves is left
    uint entered;     // intersected leaves that the ray meets
    uint mark;        // the last pass in which a subtracted leaf began at the depth or before it
    uint leaf;        // of the surface at the depth, as the stack holds it (layers/surface_ids.glsl)
    uint plane;
    uint best_depth;  // of all products so far
    uint best_leaf;
    uint best_plane;
};
layout(std430, binding = 2) buffer ScsPixels { ScsPixel pixels[]; };

uniform ivec2 band_size;   // width and rows of the band
uniform uint intersected;  // leaves of the product that are not subtracted

uint pixel_index(ivec2 p) { return uint(p.y * band_size.x + p.x); }

// Is there a point of the product, as far as it is known?
bool is_alive(ScsPixel pixel) { return pixel.entered == intersected && pixel.depth > pixel.limit; }
