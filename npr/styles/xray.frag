#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/edges/lines.glsl"
#include "npr/surface_color.glsl"
#include "npr/settings.glsl"

out vec4 result;

#include "npr/edges/ink_of_layers.glsl"

#include "npr/styles/xray.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    find_ink(pixel, Pens(width, inner_width, hidden_width, profile_strength, inner_strength));
    result = xray(pixel);
}
