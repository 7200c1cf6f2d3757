// Ink of lines. Valid in shaders and, within a struct with the same names, in C++. Positions are counted in samples:
// pixel (x, y) has its sample at (x, y), whatever the jitter.

struct Edge {
    float profile;  // coverage of the pixel by the line, in [0, 1]
    float inner;
};

Edge no_edge() {
    Edge e;
    e.profile = 0.0f;
    e.inner = 0.0f;
    return e;
}

// The links that a line of that width reaches `at` from: those that start at pixels from x, y to z, w.
ivec4 links_near(vec2 at, float width) {
    float reach = 0.5f * width + 0.5f;
    ivec2 last = picture_size() - 1;
    return ivec4(clamp(ivec2(ceil(at - reach)) - 1, ivec2(0), last), clamp(ivec2(floor(at + reach)), ivec2(0), last));
}

// Coverage by the piece of a line about one edge point. Points follow each other at 1.42f pixels at most.
float piece(vec2 from_point, vec2 across, float width) {
    float beside = dot(from_point, across);
    float beyond = max(abs(dot(from_point, vec2(-across.y, across.x))) - 0.71f, 0.0f);
    return clamp(0.5f * width + 0.5f - length(vec2(beside, beyond)), 0.0f, 1.0f);
}

// The same without smoothing, 1 or 0, as OpenGL draws lines: `width` is counted along rows or columns, whichever cross
// the line more nearly.
float hard_piece(vec2 from_point, vec2 across, float width) {
    bool beside = abs(dot(from_point, across)) < 0.5f * width * max(abs(across.x), abs(across.y));
    return beside && abs(dot(from_point, vec2(-across.y, across.x))) <= 0.75f ? 1.0f : 0.0f;
}

// The ink of outlines about what is so thin (EdgePoint::thickness) that lines of that width would fill it.
float thin_ink(float thickness, float width) {
    return thickness >= 1.0f ? 1.0f : clamp(0.25f + 0.75f * 4.0f * thickness / (2.2f * width), 0.0f, 1.0f);
}

// About as bright as the eye sees it, 0 to 1.
float brightness(vec3 color) {
    return dot(color, vec3(0.299f, 0.587f, 0.114f));
}

// The color of lines that stand out from a part: dark lines on a dark part become light there.
vec3 line_color_on(vec3 line, vec3 part) {
    float dark = clamp((0.32f - brightness(part)) / 0.08f, 0.0f, 1.0f) * clamp((0.4f - brightness(line)) / 0.1f, 0.0f, 1.0f);
    return mix(line, vec3(0.62f), dark);
}

// A color with a line over it, of which there is so much ink (0 to 1). Straight alpha.
vec4 with_line(vec4 c, vec3 line_color, float ink) {
    float alpha = mix(c.a, 1.0f, ink);
    return vec4(mix(vec3(c) * c.a, line_color, ink) / max(alpha, 1e-6f), alpha);
}
