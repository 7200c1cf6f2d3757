#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/surface_color.glsl"

#include "npr/styles/shaded.glsl"

out vec4 result;

void main() {
    result = shaded(ivec2(gl_FragCoord.xy));
}
