#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/settings.glsl"
#include "npr/surface_color.glsl"
#include "tests/npr/own_style.glsl"

out vec4 result;

void main() {
    result = bands(ivec2(gl_FragCoord.xy));
}
