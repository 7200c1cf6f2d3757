// Colors of surfaces as in OpenSCAD's preview. Valid in shaders and, within a struct with the same names, in C++.

#include "npr/section_lines.glsl"
#include "peel/composite.glsl"

// Ambient light and two lights from opposite sides, fixed to the eye; flat, as the facets are.
#include "npr/light_direction.glsl"

float light(vec3 normal) {
    return 0.2f + abs(dot(mat3(view.eye_from_world) * normal, kLightDirection));
}

// Not lit; straight alpha.
vec4 base_color(Surface s) {
    if (s.part_kind == kPartHighlight)
        return highlight_color;
    bool cut = s.reversed && s.part_kind == kPartSolid;
    vec4 otherwise = s.part_kind == kPartBackground ? ghost_color : vec4(cut ? cut_color : face_color, 1.0f);
    return vec4(s.color.r >= 0.0f ? s.color.r : otherwise.r, s.color.g >= 0.0f ? s.color.g : otherwise.g,
                s.color.b >= 0.0f ? s.color.b : otherwise.b, s.color.a >= 0.0f ? s.color.a : otherwise.a);
}

// The same; of translucent parts only the faces toward the eye are seen, unless others are asked for.
vec4 seen_color(Surface s) {
    vec4 color = base_color(s);
    return s.covered || (color.a < 1.0f && s.leaving && !back_faces) ? vec4(0.0f) : color;
}

// Cool where the light does not fall, warm where it does (Gooch, Gooch, Shirley and Cohen 1998).
vec3 cool_to_warm(vec3 color, vec3 normal) {
    float warm = 0.5f + 0.5f * dot(mat3(view.eye_from_world) * normal, kLightDirection);
    return min(mix(vec3(0.0f, 0.0f, 0.4f) + 0.2f * color, vec3(0.4f, 0.4f, 0.0f) + 0.6f * color, warm), 1.0f);
}

// A color, straight alpha, with a black line over it.
vec4 with_silhouette(vec4 c, float ink) {
    float alpha = mix(c.a, 1.0f, ink);
    return vec4(vec3(c) * (c.a * (1.0f - ink) / max(alpha, 1e-6f)), alpha);
}

// Lit, sRGB with straight alpha.
vec4 surface_color(Surface s) {
    vec4 color = seen_color(s);
    if (color.a == 0.0f && s.ink == 0.0f)
        return color;
    if (gooch_shading && !is_section(s.leaf)) {
        vec3 tone = cool_to_warm(min(vec3(color), 1.0f), s.leaving ? -s.normal : s.normal);
        return with_silhouette(vec4(tone, color.a), s.ink);
    }
    float lit = light(s.normal);
    if (is_section(s.leaf))
        lit = mix(lit, 1.0f, 0.6f);  // Nearly flat, as in drawings: hatching is as clear on all of them.
    vec4 shaded = vec4(min(vec3(color) * lit, 1.0f), color.a);
    return s.ink > 0.0f ? with_silhouette(shaded, s.ink) : shaded;
}

#include "npr/transparency.glsl"

// What lies before the picture's ground, as its linear light. `color` is premultiplied; so much light comes `through`
// it.
vec4 before_ground(vec3 color, float through, vec3 ground) {
    if (!transparent_background) {
        color += through * ground;
        through = 0.0f;
    }
    float alpha = 1.0f - through;
    return premultiplied(color / max(alpha, 1e-6f), alpha);
}

vec4 before_background(vec3 color, float through, ivec2 pixel) {
    return before_ground(color, through, background(pixel));
}
