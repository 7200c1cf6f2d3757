#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/edges/lines.glsl"
#include "npr/section_lines.glsl"
#include "npr/settings.glsl"

out vec4 result;

#include "npr/edges/ink_of_layers.glsl"


#include "npr/styles/blueprint_lines.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    find_ink(pixel, Pens(width, inner_width, hidden_width, 1.0, 1.0));
    result = blueprint_lines(pixel);
}
