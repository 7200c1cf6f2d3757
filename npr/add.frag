// One sample, to be added to the sum by blending.
layout(binding = 0) uniform sampler2D one_sample;
out vec4 result;

void main() {
    result = texelFetch(one_sample, ivec2(gl_FragCoord.xy), 0);
}
