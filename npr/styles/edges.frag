#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/edges/lines.glsl"
#include "npr/surface_color.glsl"
#include "npr/settings.glsl"

out vec4 result;

// Of the pixel: layers with edges so near that their lines may cover it.
uint layers_with_lines;

bool line_near(int layer) {
    return (layers_with_lines >> edge_layer(layer) & 1u) != 0u;
}

float line_ink(int layer) {
    Edge edge = edge_at(floor(gl_FragCoord.xy), layer, width, inner_width, smooth_lines ? kLight : kHard);
    return max(edge.profile, inner_strength * edge.inner);
}

#include "npr/styles/edges.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    layers_with_lines = layers_near(vec2(pixel), width);
    result = edges(pixel);
}
