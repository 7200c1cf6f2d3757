// Edges of all layers, with the depth-complexity cue of Nienhaus (2005), 5.2: the tone tells how many surfaces lie
// behind each other, and edges get fainter from layer to layer.
#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/lines.glsl"

uniform float width;
uniform float hidden_width;
uniform float hidden_strength;  // of the second layer's edges
uniform float hidden_falloff;   // from layer to layer
uniform float inner_strength;
uniform float tone;             // of one layer
uniform int most_layers;        // 0: all
uniform bool grid;
uniform float grid_spacing;
uniform vec3 ground_color;
uniform vec3 line_color;
uniform vec3 wash_color;
out vec4 result;

// Coverage by lines one pixel wide, `spacing` pixels apart, in both directions.
float grid_lines(vec2 at, float spacing) {
    vec2 distance = abs(mod(at + 0.5 * spacing, spacing) - 0.5 * spacing);
    vec2 line = clamp(1.0 - distance, 0.0, 1.0);
    return max(line.x, line.y);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 ray = pixel_ray(pixel);
    int layers = most_layers > 0 ? min(most_layers, layer_count) : layer_count;
    float clear = 1.0;
    int seen = 0;
    while (seen < layers && layer_surface(pixel, seen, ray).hit) {
        ++seen;
        clear *= 1.0 - tone;
    }
    float bare = 1.0;  // of the paper, not yet covered by lines
    if (layers_near(vec2(pixel), width) != 0u) {
        float ink[kEdgeLayers];
        all_edges_at(vec2(pixel), width, hidden_width, 1.0, inner_strength, ink);
        float strength = 1.0;
        for (int i = 0; i < min(layers, kEdgeLayers); ++i) {
            bare *= 1.0 - strength * ink[i];
            strength = i == 0 ? hidden_strength : strength * hidden_falloff;
        }
    }
    // Strengths are as the eye sees them, hence mixed in sRGB.
    vec3 paper = ground_color;
    if (grid) {
        vec2 at = vec2(pixel) + 0.5 + jitter - 0.5 * view.picture.xy;
        float line = max(0.5 * grid_lines(at, grid_spacing), grid_lines(at, 5.0 * grid_spacing));
        paper = mix(paper, line_color, 0.12 * line);
    }
    vec3 color = mix(line_color, mix(wash_color, paper, clear), bare);
    float alpha = transparent_background && seen == 0 ? 0.0 : 1.0;
    result = premultiplied(color, alpha);
}
