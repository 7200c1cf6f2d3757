#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/edges/lines.glsl"

uniform float width;
uniform float hidden_width;
uniform float hidden_strength;  // of the second layer's edges
uniform float hidden_falloff;   // from layer to layer
uniform float inner_strength;
uniform float tone;             // of one layer
uniform int most_layers;        // 0: all
uniform bool grid;
uniform float grid_spacing;
uniform vec3 ground_color;
uniform vec3 line_color;
uniform vec3 wash_color;
out vec4 result;

#include "npr/edges/ink_of_layers.glsl"

#include "npr/styles/blueprint.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    find_ink(pixel, width, hidden_width, 1.0, inner_strength);
    result = blueprint(pixel);
}
