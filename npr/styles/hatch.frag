#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/edges/lines.glsl"
#include "npr/surface_color.glsl"
#include "npr/settings.glsl"

out vec4 result;

#include "npr/styles/visible_lines.glsl"

#include "npr/styles/surface_place.glsl"
#include "npr/styles/hatch.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    find_visible_lines(pixel);
    result = ink_on_paper(pixel);
}
