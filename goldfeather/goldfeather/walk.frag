// One geometry pass of the walk: toggles the leaves whose surface lies at the pixel's current event, and finds the next
// event by the depth test.
#include "goldfeather/surface_depth.glsl"
#include "goldfeather/goldfeather/walk.glsl"

flat in uint slot;
flat in uint behind; // is the leaf counted from behind?
flat in uint plane;

uniform bool starting;     // first pass: every surface is ahead
uniform bool count_inside; // first pass with the eye among the leaves: inside is counted from behind

// What a surface adds to a word of toggled_bits.
void toggle(uint word, uint pixel) {
    if (is_counter(word))
        atomicAdd(toggled_bits[word_index(word, pixel)], gl_FrontFacing ? 1u : 0xffffffffu);
    else
        atomicXor(toggled_bits[word_index(word, pixel)], 1u << (slot & 31u));
}

// The same from behind: as inside the near plane as the surface undoes.
void count_from_behind(uint word, uint pixel) {
    if (is_counter(word))
        atomicAdd(inside_bits[word_index(word, pixel)], gl_FrontFacing ? 0xffffffffu : 1u);
    else
        atomicXor(inside_bits[word_index(word, pixel)], 1u << (slot & 31u));
}

void main() {
    float depth = surface_depth();
    uint pixel = pixel_index(ivec2(gl_FragCoord.xy));
    if (starting) {
        if (count_inside && behind != 0u)
            count_from_behind(slot >> 5, pixel);
    } else {
        float current = pixels[pixel].current;
        if (depth >= current) {
            if (depth == current) {
                toggle(slot >> 5, pixel);
                atomicMin(pixels[pixel].plane, plane);
            }
            discard;
        }
    }
    gl_FragDepth = depth;
}
