#include "npr/frame.glsl"
#include "npr/styles/noise.glsl"
#include "npr/settings.glsl"

uniform float relief_cell;
uniform ivec2 relief_cells;
layout(std430, binding = 15) readonly buffer ReliefRows { float relief_rows[]; };

ivec2 relief_size() {
    return relief_cells;
}

float relief_distance(ivec2 cell) {
    return relief_rows[cell.y * relief_cells.x + cell.x];
}

out vec4 result;

// Smooth, about -1 to 1, mean 0; features about 1 apart.
float perlin_noise(vec3 p, uint s) {
    vec3 low = floor(p);
    return noise_between(gradients_about(ivec3(low), s), p - low);
}

#include "npr/styles/sketch_noise.glsl"

void main() {
    result = sketch_noise(ivec2(gl_FragCoord.xy));
}
