// The nearest opaque surface, and translucent ones before it. Valid in shaders and, within a struct with the same
// names, in C++.
vec4 shaded(ivec2 pixel) {
    vec3 ray = pixel_ray(pixel);
    Composite seen = nothing_seen();
    Media media = media_at_eye(pixel);
    while (goes_on(seen, layer_count, least_seen())) {
        Surface s = seen_surface(pixel, seen.layer, ray);
        seen = reached(seen, media, s, ray);
        media = beyond(media, s);
        vec4 c = vec4(0.0f);
        if (s.hit)
            c = hatched(surface_color(s), s.leaf, s.plane, pixel);
        seen = behind(seen, s.hit, c);
    }
    return before_background(seen.color, seen.through, pixel);
}
