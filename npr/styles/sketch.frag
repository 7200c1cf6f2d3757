#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/edges/lines.glsl"
#include "npr/styles/noise.glsl"
#include "npr/surface_color.glsl"
#include "npr/settings.glsl"

layout(binding = 7) uniform sampler2D noise_of_picture;
out vec4 result;

#include "npr/styles/hatching.glsl"
#include "npr/styles/sketch.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    result = sketch(pixel, texelFetch(noise_of_picture, pixel, 0), paper_grain(pixel - guard, seed));
}
