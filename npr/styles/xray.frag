#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/edges/lines.glsl"
#include "npr/surface_color.glsl"

uniform float width;
uniform float opacity;  // of a layer that faces the eye
uniform float rim;
uniform float profile_strength;
uniform float inner_strength;
uniform float falloff;
uniform float cue;
uniform int colors;       // 0: of the model, 1: by layer, 2: none
uniform int most_layers;  // 0: all
out vec4 result;

#include "npr/edges/ink_of_layers.glsl"

#include "npr/styles/xray.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    find_ink(pixel, width, width, profile_strength, inner_strength);
    result = xray(pixel);
}
