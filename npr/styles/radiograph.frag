#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/settings.glsl"

#include "npr/styles/radiograph.glsl"

out vec4 result;

void main() {
    result = radiograph(ivec2(gl_FragCoord.xy));
}
