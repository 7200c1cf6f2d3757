// The sum of samples to sRGB with straight alpha.
#include "npr/color.glsl"

layout(binding = 0) uniform sampler2D sum;
uniform int samples;
uniform ivec2 corner;
out vec4 result;

void main() {
    vec4 c = texelFetch(sum, ivec2(gl_FragCoord.xy) - corner, 0) / float(samples);
    result = c.a > 0.0 ? vec4(srgb_from_linear(clamp(c.rgb / c.a, 0.0, 1.0)), min(c.a, 1.0)) : vec4(0.0);
}
