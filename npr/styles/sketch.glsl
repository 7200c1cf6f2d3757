// Sketchy drawing (Nienhaus 2005, chapter 6): edge map and shade map are each read with an offset, which is a smooth
// noise turned by a matrix of its own. Strokes are repeated with further matrices (6.6); all layers have the same
// noise, so that a sketched blueprint keeps together (6.8). Valid in shaders and, within a struct with the same names,
// in C++.

#include "npr/smooth_normal.glsl"

mat2 stroke_turn(int j) {
    if (j == 0)
        return mat2(1.0f, 0.1f, -0.1f, 1.0f);
    if (j == 1)
        return mat2(-0.55f, 0.6f, -0.7f, -0.45f);
    return j == 2 ? mat2(0.3f, -0.95f, 0.9f, 0.25f) : mat2(-0.9f, -0.4f, 0.3f, -1.0f);
}

// Where a map is read that noise sets off.
vec2 displaced(ivec2 pixel, mat2 turn, vec4 noise) {
    return vec2(pixel) + wobble * (turn * vec2(noise));
}

ivec2 nearest_pixel(vec2 at) {
    return ivec2(floor(at + 0.5f));
}

float luminance(vec3 c) {
    return dot(c, vec3(0.2126f, 0.7152f, 0.0722f));
}

// Pressed hard, the medium fills the grain of the paper; lightly, it stays on its tops.
float deposit(float coverage, float pressure, float grain) {
    if (medium == 1)
        return coverage;
    float depth = medium == 2 ? 0.75f : 0.45f;
    return coverage * smoothstep(grain * depth - 0.22f, grain * depth + 0.3f, pressure * coverage);
}

// Coverage by the lines of visible edges, of all that is seen through translucent surfaces.
float visible_lines(vec2 at, uint lines, float thick) {
    ivec2 p = nearest_pixel(at);
    vec3 ray = pixel_ray(p);
    float ink = 0.0f;
    Composite seen = nothing_seen();
    while (goes_on(seen, layer_count, 0.05f) && lines >> edge_layer(seen.layer) != 0u) {
        if ((lines >> edge_layer(seen.layer) & 1u) != 0u) {
            Edge edge = edge_at(at, seen.layer, thick);
            ink = max(ink, seen.through * max(edge.profile, inner_strength * edge.inner));
        }
        Surface s = layer_surface(p, seen.layer, ray);
        vec4 tint = vec4(0.0f);
        if (s.hit)
            tint = seen_color(s);
        seen = behind(seen, s.hit, tint);
    }
    return ink;
}

// Of all layers but the first.
float hidden_lines(vec2 at, float thick) {
    float ink = 0.0f;
    float strength = 1.0f;
    uint lines = layers_near(at, thick);
    for (int i = 1; i < min(layer_count, kLayersApart) && lines >> i != 0u; ++i) {
        if ((lines >> i & 1u) != 0u) {
            Edge edge = edge_at(at, i, thick);
            ink = max(ink, strength * max(edge.profile, hidden_inner * edge.inner));
        }
        strength *= hidden_falloff;
    }
    return ink;
}

// How the hand presses on the way of a stroke: repeated ones come and go.
float swing_of(int j, vec4 noise) {
    if (j == 0)
        return noise.z;
    vec2 pressures = vec2(noise.z, noise.w);
    return dot(pressures, j == 1 ? vec2(-0.6f, 0.9f) : j == 2 ? vec2(0.9f, 0.6f) : vec2(-0.9f, -0.5f));
}

// Ink of one stroke along the visible edges, and of a lighter one along hidden edges.
float stroke_ink(int j, ivec2 pixel, vec4 noise, float grain) {
    vec2 at = displaced(pixel, stroke_turn(j), noise);
    float swing = swing_of(j, noise);
    float thick = width * (medium == 2 ? 1.6f : 1.0f) * (j == 0 ? 1.0f : 0.8f) * (0.9f + 0.5f * swing);
    thick = clamp(thick, 0.5f * width, 2.0f * width);
    uint lines = layers_near(at, thick);
    Edge beyond = overshoot_at(at, thick);
    float ink = 0.8f * max(beyond.profile, 0.8f * beyond.inner);
    bool behind = hidden > 0.0f && j == 0;
    if (lines == 0u && ink == 0.0f && !behind)
        return 0.0f;
    ink = max(ink, visible_lines(at, lines, thick));
    float pressure = j == 0 ? 0.85f + 0.4f * swing : smoothstep(-0.35f, 0.5f, swing + 0.15f) * 0.7f;
    ink = deposit(ink, pressure, grain);
    if (behind)
        ink = max(ink, hidden * deposit(hidden_lines(at, hidden_width), 0.7f * pressure, grain));
    // A pen draws as dark as it can, whatever the pressure.
    return medium == 1 && j == 0 ? ink : ink * min(pressure, 1.0f);
}

// The shade map: color and tone of the nearest surface, and of others behind translucent ones.
struct Shade {
    vec3 tone;      // premultiplied
    float through;  // so much is seen of the paper
    float ink;      // of hatching
    float depth;    // of the nearest surface; 0: none
};

Shade shade_of(ivec2 pixel, vec4 noise, float grain) {
    Shade shade;
    shade.ink = 0.0f;
    shade.depth = 0.0f;
    bool light_on_dark = luminance(ink_color) > luminance(paper_color);
    ivec2 shade_at = nearest_pixel(displaced(pixel, mat2(-2.3f, 1.1f, -1.3f, -2.0f), noise));
    vec3 ray = pixel_ray(shade_at);
    Composite seen = nothing_seen();
    while (goes_on(seen, layer_count, 0.0f)) {
        Surface s = layer_surface(shade_at, seen.layer, ray);
        if (seen.layer == 0)
            shade.depth = s.depth;
        vec4 tint = vec4(0.0f);
        if (s.hit)
            tint = seen_color(s);
        if (tint.a > 0.0f) {
            Surface lit_surface = rounded(s, shade_at);
            float lit = sketch_light(lit_surface);
            vec3 lit_tint = light_on_dark ? vec3(tint) * (0.35f + 0.75f * lit)
                                          : mix(vec3(tint), vec3(1.0f), 0.15f) * (0.62f + 0.42f * lit);
            float shadow = light_on_dark ? lit : 1.0f - lit;
            vec2 at = vec2(pixel - guard) + 0.5f + jitter + 0.5f * wobble * vec2(noise.z, noise.w);
            float strokes_here = hatch > 0.0f ? hatching(at, lit_surface.normal, shadow) : 0.0f;
            shade.ink = max(shade.ink, seen.through * hatch * deposit(strokes_here, 0.75f + 0.35f * noise.w, grain));
            tint = hatched(vec4(min(lit_tint, 1.0f), tint.a), s.leaf, s.plane, shade_at);
        }
        seen = behind(seen, s.hit, tint);
    }
    shade.tone = seen.color;
    shade.through = seen.through;
    return shade;
}

// `noise`, `grain`: of the pixel.
vec4 sketch(ivec2 pixel, vec4 noise, float grain) {
    Shade shade = shade_of(pixel, noise, grain);
    vec3 color = paper_color * (1.0f - (medium == 1 ? 0.0f : 0.03f) * (grain - 0.5f));
    float cover = clamp(wash * (0.86f + 0.2f * noise.w + 0.12f * (grain - 0.5f)), 0.0f, 1.0f);
    color = mix(color, shade.tone + shade.through * color, cover);
    if (layer_tone > 0.0f) {
        ivec2 under = nearest_pixel(displaced(pixel, stroke_turn(0), noise));
        float clear = 1.0f;
        for (int i = 0; i < layer_count && in_picture(under) && surface_ids(under, i).x != kNoSurface; ++i)
            clear *= 1.0f - layer_tone;
        color = mix(ink_color, color, clear);
    }
    float bare = 1.0f - shade.ink;
    for (int j = 0; j < strokes; ++j)
        bare *= 1.0f - stroke_ink(j, pixel, noise, grain);
    color = mix(ink_color, color, bare);

    // Something is drawn where either the shades or the edges are a surface's.
    if (transparent_background && shade.depth == 0.0f) {
        ivec2 edge_pixel = nearest_pixel(displaced(pixel, stroke_turn(0), noise));
        if (!layer_surface(edge_pixel, 0, pixel_ray(edge_pixel)).hit)
            return premultiplied(ink_color, 1.0f - bare);
    }
    return premultiplied(color, 1.0f);
}
