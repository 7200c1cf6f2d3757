#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/edges/lines.glsl"
#include "npr/styles/noise.glsl"
#include "npr/surface_color.glsl"

uniform uint seed;
uniform float unit;    // pixels in a 512th of the picture's height
uniform float width;
uniform float wobble;  // pixels
uniform int strokes;
uniform int medium;    // 0: pencil, 1: ink, 2: chalk
uniform float hatch;
uniform float wash;
uniform float hidden;
uniform vec3 ink_color;
uniform vec3 paper_color;
layout(binding = 7) uniform sampler2D noise_of_picture;
out vec4 result;

#include "npr/styles/hatching.glsl"
#include "npr/styles/sketch.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    result = sketch(pixel, texelFetch(noise_of_picture, pixel, 0), paper_grain(pixel, seed));
}
