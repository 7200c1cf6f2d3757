// Per-pixel state of the walk along the ray; see goldfeather/engine.h.

struct PixelState {
    float current;  // depth of the event that the next geometry pass toggles; 0: this pixel is done
    uint found;     // layers found << 1 | inside the result
    uint plane;     // smallest plane id among the surfaces of the event
    uint unused;
};
layout(std430, binding = 2) buffer Pixels { PixelState pixels[]; };
layout(std430, binding = 3) buffer InsideBits { uint inside_bits[]; };    // parity of each slot's leaf, by word
layout(std430, binding = 4) buffer ToggledBits { uint toggled_bits[]; };  // slots that change at the event, by word

uniform ivec2 band_size;  // width and rows of the band

uint pixel_index(ivec2 p) { return uint(p.y * band_size.x + p.x); }
uint word_index(uint word, uint pixel) { return word * uint(band_size.x * band_size.y) + pixel; }
