// Colors of surfaces as in OpenSCAD's preview.
#include "npr/frame.glsl"

// Ambient light and two lights from opposite sides, fixed to the eye; flat, as the facets are.
float light(vec3 normal) {
    const vec3 direction = vec3(-0.57735027, 0.57735027, 0.57735027);
    return 0.2 + abs(dot(mat3(view.eye_from_world) * normal, direction));
}

// Not lit; straight alpha.
vec4 base_color(Surface s) {
    if (s.part_kind == kPartHighlight)
        return highlight_color;
    if (s.part_kind == kPartBackground)
        return ghost_color;
    if (s.color.r >= 0.0)
        return s.color;
    return vec4(s.reversed ? cut_color : face_color, 1.0);
}

// The same; of translucent parts only the faces toward the eye are seen.
vec4 seen_color(Surface s) {
    vec4 color = base_color(s);
    return color.a < 1.0 && s.leaving ? vec4(0.0) : color;
}

// Lit, sRGB with straight alpha.
vec4 surface_color(Surface s) {
    vec4 color = seen_color(s);
    return vec4(min(color.rgb * light(s.normal), 1.0), color.a);
}
