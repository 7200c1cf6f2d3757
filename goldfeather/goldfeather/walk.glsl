// Per-pixel state of the walk along the ray; see goldfeather/goldfeather/goldfeather.h.

struct PixelState {
    float current;  // depth of the event that the next geometry pass toggles; 0: this pixel is done
    uint found;     // layers found << 1 | inside the result
    uint plane;     // smallest plane id among the surfaces of the event
    uint unused;
};
layout(std430, binding = 2) buffer Pixels { PixelState pixels[]; };
layout(std430, binding = 3) buffer InsideBits { uint inside_bits[]; };    // parity of each slot's leaf, or a winding number, by word
layout(std430, binding = 4) buffer ToggledBits { uint toggled_bits[]; };  // what the event adds to that, by word

uniform ivec2 band_size;  // width and rows of the band

uint pixel_index(ivec2 p) { return uint(p.y * band_size.x + p.x); }
uint word_index(uint word, uint pixel) { return word * uint(band_size.x * band_size.y) + pixel; }

// Words from `first_counter` on are winding numbers, of one leaf each. kCounters: are there any?
uniform uint first_counter;
bool is_counter(uint word) { return kCounters && word >= first_counter; }
