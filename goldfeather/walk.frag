// One geometry pass of the walk: toggles the leaves whose surface lies at the pixel's current event, and finds the next
// event by the depth test.
#include "goldfeather/surface_depth.glsl"
#include "goldfeather/walk.glsl"

flat in uint slot;
flat in uint plane;

uniform bool starting;     // first pass: every surface is ahead
uniform bool count_inside; // first pass with the eye among the leaves: inside is counted from behind

void main() {
    float depth = surface_depth();
    uint pixel = pixel_index(ivec2(gl_FragCoord.xy));
    if (starting) {
        if (count_inside)
            atomicXor(inside_bits[word_index(slot >> 5, pixel)], 1u << (slot & 31u));
    } else {
        float current = pixels[pixel].current;
        if (depth >= current) {
            if (depth == current) {
                atomicXor(toggled_bits[word_index(slot >> 5, pixel)], 1u << (slot & 31u));
                atomicMin(pixels[pixel].plane, plane);
            }
            discard;
        }
    }
    gl_FragDepth = depth;
}
