// Sketchy drawing (Nienhaus 2005, chapter 6): edge map and shade map are each read with an offset, which is a smooth
// noise turned by a matrix of its own. Strokes are repeated with further matrices (6.6); all layers have the same
// noise, so that a sketched blueprint keeps together (6.8).
#include "npr/color.glsl"
#include "npr/frame.glsl"
#include "npr/hatching.glsl"
#include "npr/lines.glsl"
#include "npr/surface_color.glsl"

uniform float width;
uniform float wobble;  // pixels
uniform int strokes;
uniform int medium;    // 0: pencil, 1: ink, 2: chalk
uniform float hatch;
uniform float wash;
uniform float hidden;
uniform vec3 ink_color;
uniform vec3 paper_color;
layout(binding = 7) uniform sampler2D sketch_noise;
out vec4 result;

const mat2 kStrokeTurns[4] = mat2[4](mat2(1.0, 0.1, -0.1, 1.0), mat2(-0.55, 0.6, -0.7, -0.45),
                                     mat2(0.3, -0.95, 0.9, 0.25), mat2(-0.9, -0.4, 0.3, -1.0));
const mat2 kShadeTurn = mat2(-2.3, 1.1, -1.3, -2.0);

float luminance(vec3 c) {
    return dot(c, vec3(0.2126, 0.7152, 0.0722));
}

// Pressed hard, the medium fills the grain of the paper; lightly, it stays on its tops.
float deposit(float coverage, float pressure, float grain) {
    if (medium == 1)
        return coverage;
    float depth = medium == 2 ? 0.75 : 0.45;
    return coverage * smoothstep(grain * depth - 0.22, grain * depth + 0.3, pressure * coverage);
}

// Ink of one stroke along the visible edges, and of a lighter one along hidden edges.
float stroke_ink(int j, vec2 at, vec4 noise, float grain) {
    at += wobble * (kStrokeTurns[j] * noise.xy);
    // The hand presses and lifts on its way; repeated strokes come and go.
    float swing = j == 0 ? noise.z : dot(noise.zw, j == 1 ? vec2(-0.6, 0.9) : j == 2 ? vec2(0.9, 0.6) : vec2(-0.9, -0.5));
    float pressure = j == 0 ? 0.85 + 0.4 * swing : smoothstep(-0.35, 0.5, swing + 0.15) * 0.7;
    float thick = width * (medium == 2 ? 1.6 : 1.0) * (j == 0 ? 1.0 : 0.8) * (0.9 + 0.5 * swing);
    thick = clamp(thick, 0.5 * width, 2.0 * width);
    Edge beyond = overshoot_at(at, thick);
    float ink = 0.8 * max(beyond.profile, 0.8 * beyond.inner);
    uint lines = layers_near(at, thick);
    ivec2 p = ivec2(floor(at + 0.5));
    vec3 ray = pixel_ray(p);
    float through = 1.0;
    for (int i = 0; i < layer_count && lines >> edge_layer(i) != 0u && through > 0.05; ++i) {
        if ((lines >> edge_layer(i) & 1u) != 0u) {
            Edge edge = edge_at(at, i, thick);
            ink = max(ink, through * max(edge.profile, 0.72 * edge.inner));
        }
        Surface s = layer_surface(p, i, ray);
        if (!s.hit)
            break;
        through *= 1.0 - seen_color(s).a;
    }
    ink = deposit(ink, pressure, grain);
    if (hidden > 0.0 && j == 0) {
        float behind = 0.0;
        uint others = layers_near(at, 0.75 * width);
        for (int i = 1; i < min(layer_count, kEdgeLayers) && others >> i != 0u; ++i)
            if ((others >> i & 1u) != 0u) {
                Edge edge = edge_at(at, i, 0.75 * width);
                behind = max(behind, max(edge.profile, 0.8 * edge.inner));
            }
        ink = max(ink, hidden * deposit(behind, 0.7 * pressure, grain));
    }
    // A pen draws as dark as it can, whatever the pressure.
    return medium == 1 && j == 0 ? ink : ink * min(pressure, 1.0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 noise = texelFetch(sketch_noise, pixel, 0);
    // Grain and paper belong to the pixel, whatever the sample.
    vec3 rough = white_noise(pixel, seed + 77u);
    vec3 coarse = white_noise(pixel / 2, seed + 78u);
    float grain = 0.55 * rough.x + 0.45 * coarse.x;

    // The shade map: color and tone of the nearest surface, and of others behind translucent ones.
    ivec2 shade_at = ivec2(floor(vec2(pixel) + wobble * (kShadeTurn * noise.xy) + 0.5));
    vec3 shade_ray = pixel_ray(shade_at);
    Surface nearest = layer_surface(shade_at, 0, shade_ray);
    bool light_on_dark = luminance(ink_color) > luminance(paper_color);
    vec3 color = paper_color * (1.0 - (medium == 1 ? 0.0 : 0.03) * (grain - 0.5));
    float drawn = 0.0;  // ink
    float shade_through = 1.0;
    vec3 tone = vec3(0.0);
    for (int i = 0; i < layer_count && shade_through > 0.0; ++i) {
        Surface s = layer_surface(shade_at, i, shade_ray);
        if (!s.hit)
            break;
        vec4 tint = seen_color(s);
        float lit = sketch_light(s);
        vec3 lit_tint = light_on_dark ? tint.rgb * (0.35 + 0.75 * lit)
                                      : mix(tint.rgb, vec3(1.0), 0.15) * (0.62 + 0.42 * lit);
        tone += shade_through * tint.a * min(lit_tint, 1.0);
        float shadow = light_on_dark ? lit : 1.0 - lit;
        vec2 at = vec2(pixel) + 0.5 + jitter + 0.5 * wobble * noise.zw;
        if (tint.a > 0.0)
            drawn = max(drawn, shade_through * hatch *
                                   deposit(hatching(at, s.normal, shadow), 0.75 + 0.35 * noise.w, grain));
        shade_through *= 1.0 - tint.a;
    }
    float cover = clamp(wash * (0.86 + 0.2 * noise.w + 0.12 * (grain - 0.5)), 0.0, 1.0);
    color = mix(color, tone + shade_through * color, cover);
    float bare = 1.0 - drawn;
    for (int j = 0; j < strokes; ++j)
        bare *= 1.0 - stroke_ink(j, vec2(pixel), noise, grain);
    color = mix(ink_color, color, bare);

    // Something is drawn where either the edges' or the shades' depth is that of a surface: the nearer of the two.
    ivec2 edge_at_pixel = ivec2(floor(vec2(pixel) + wobble * (kStrokeTurns[0] * noise.xy) + 0.5));
    float depth = max(nearest.depth, layer_surface(edge_at_pixel, 0, pixel_ray(edge_at_pixel)).depth);
    float alpha = transparent_background && depth == 0.0 ? 1.0 - bare : 1.0;
    if (transparent_background && depth == 0.0)
        color = ink_color;
    result = premultiplied(color, alpha);
}
