// Cartoon shading (Lake et al. 2000; Nienhaus 2005, 4.6): light finds a tone in a palette of few. Steps between tones
// are smoothed as there, by blurring the map of tones. Valid in shaders and, within a struct with the same names, in
// C++.

#include "npr/shadow.glsl"
#include "npr/smooth_normal.glsl"

// Of the palette: 0 to steps - 1; `steps` where a highlight lightens the lightest.
int toon_tone(Surface s, vec3 direction, bool shadowed) {
    if (shadowed)
        return 0;
    mat3 turn = mat3(view.eye_from_world);
    vec3 n = turn * s.normal;
    float mirrored = max(dot(reflect(kLightDirection, n), turn * direction), 0.0f);
    if (highlight > 0.0f && mirrored > 0.94f)
        return steps;
    return clamp(int(float(steps) * max(dot(n, kLightDirection), 0.0f)), 0, steps - 1);
}

// May a neighbor on the same smooth surface have another tone?
bool near_a_step(Surface s, vec3 direction) {
    mat3 turn = mat3(view.eye_from_world);
    vec3 n = turn * s.normal;
    float value = float(steps) * max(dot(n, kLightDirection), 0.0f);
    float mirrored = max(dot(reflect(kLightDirection, n), turn * direction), 0.0f);
    return abs(value - floor(value + 0.5f)) < 0.25f || (highlight > 0.0f && abs(mirrored - 0.94f) < 0.05f);
}

vec3 toon_color(vec3 base, int tone) {
    if (tone == steps)
        return mix(base, vec3(1.0f), highlight);
    return base * mix(shadow, 1.0f, float(tone) / float(steps - 1));
}

// The color of a neighbor where it is one surface with `s`, else that of `s`, which is `own`.
vec3 toon_beside(ivec2 pixel, int layer, Surface s, vec3 base, vec3 own) {
    if (!in_picture(pixel))
        return own;
    uvec2 ids = surface_ids(pixel, layer);
    if (ids.x == kNoSurface || (leaf_of(ids) == s.leaf && plane_of(ids) == s.plane && highlight == 0.0f && !smooth_shading))
        return own;
    vec3 ray = pixel_ray(pixel);
    Surface t = layer_surface(pixel, layer, ray);
    return t.leaf == s.leaf && t.leaving == s.leaving ? toon_color(base, toon_tone(rounded(t, pixel), normalize(ray), false)) : own;
}

vec3 toon_blurred(ivec2 pixel, int layer, Surface s, vec3 base, vec3 direction) {
    Surface lit = rounded(s, pixel);
    bool shadowed = in_shadow(pixel, layer);
    vec3 own = toon_color(base, toon_tone(lit, direction, shadowed));
    if (shadowed)
        return own;
    if (smooth_shading && !near_a_step(lit, direction))
        return own;
    vec3 sum = 4.0f * own;
    sum += toon_beside(pixel + ivec2(1, 0), layer, s, base, own);
    sum += toon_beside(pixel - ivec2(1, 0), layer, s, base, own);
    sum += toon_beside(pixel + ivec2(0, 1), layer, s, base, own);
    sum += toon_beside(pixel - ivec2(0, 1), layer, s, base, own);
    return sum / 8.0f;
}

vec4 toon(ivec2 pixel) {
    vec3 ray = pixel_ray(pixel);
    vec3 direction = normalize(ray);
    Composite seen = nothing_seen();
    Media media = media_at_eye(pixel);
    while (goes_on(seen, layer_count, least_seen())) {
        Surface s = seen_surface(pixel, seen.layer, ray);
        seen = reached(seen, media, s, ray);
        media = beyond(media, s);
        vec4 c = vec4(0.0f);
        if (s.hit)
            c = seen_color(s);
        if (c.a > 0.0f)
            c = hatched(vec4(toon_blurred(pixel, seen.layer, s, vec3(c), direction), c.a), s.leaf, s.plane, pixel);
        if (line_near(seen.layer) && !(s.hit && c.a == 0.0f && !bounds_medium(s)))
            c = with_line(c, edge_color, line_ink(seen.layer));
        seen = behind(seen, s.hit, c);
    }
    return before_background(seen.color, seen.through, pixel);
}
