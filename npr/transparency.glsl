// What is seen through parts that are not opaque, by the picture's model of transparency. Valid in shaders and, within a
// struct with the same names, in C++. Styles that shade surfaces walk the layers so:
//
//     Composite seen = nothing_seen();
//     Media media = media_at_eye(pixel);
//     while (goes_on(seen, layer_count, least_seen())) {
//         Surface s = seen_surface(pixel, seen.layer, ray);
//         seen = reached(seen, media, s, ray);
//         media = beyond(media, s);
//         seen = behind(seen, s.hit, (its color, by seen_color or surface_color));
//     }

#include "peel/media.glsl"

// As Transparency (npr/transparency.h).
const int kExact = 0;
const int kVolume = 1;
const int kViewDependent = 2;
const int kScreenDoor = 3;
const int kSorted = 4;

// Less light than this is as good as none.
float least_seen() {
    return transparency == kVolume ? 1.0f / 4096.0f : 0.0f;
}

// Of the faces that parts have in one place, which one is seen? The most opaque; of those the one of the larger color,
// so that no order of parts matters, and `%` only where it is alone. Highlights are seen in any case.
bool yields(vec4 color, uint kind, vec4 other, uint other_kind) {
    bool highlight = kind == kPartHighlight;
    if (highlight != (other_kind == kPartHighlight))
        return false;
    bool background = kind == kPartBackground;
    if (background != (other_kind == kPartBackground))
        return background;
    if (color.a != other.a)
        return color.a < other.a;
    if (color.r != other.r)
        return color.r < other.r;
    if (color.g != other.g)
        return color.g < other.g;
    return color.b < other.b;
}

bool yields_to(Surface s, vec4 color, Surface t) {
    return t.plane == s.plane && t.leaving == s.leaving && yields(color, s.part_kind, base_color(t), t.part_kind);
}

// Is the face that of another part as well, which is seen in its place?
bool shared_with_another(Surface s, ivec2 pixel, int layer, vec3 ray) {
    bool before = layer > 0 && layer_depth(pixel, layer - 1) == s.depth;
    if (s.leaving || !(before || layer_depth(pixel, layer + 1) == s.depth))
        return false;
    vec4 color = base_color(s);
    if (color.a >= 1.0f)
        return false;
    for (int i = layer - 1; i >= 0 && layer_depth(pixel, i) == s.depth; --i) {
        Surface t = layer_surface(pixel, i, ray);
        bool twin = t.plane == s.plane && t.leaving == s.leaving && t.part_kind == s.part_kind;
        if (yields_to(s, color, t) || (twin && base_color(t) == color))
            return true;
    }
    for (int i = layer + 1; i < layer_count && layer_depth(pixel, i) == s.depth; ++i) {
        if (yields_to(s, color, layer_surface(pixel, i, ray)))
            return true;
    }
    return false;
}

// In view-dependent: the nearest face of what is seen through, by its distance to silhouettes, and what shows through it
// (npr/shine/shine_rules.glsl). Layers behind that are as if surfaces of no opacity were there.
Surface shone_through(Surface s, ivec2 pixel, int layer) {
    ShineRow row = shine_row(pixel);
    if (layer == row.front) {
        s.color.a = row.alpha;
        s.ink = row.front_ink;
        return s;
    }
    bool hidden = layer >= row.hidden || (row.front >= 0 && !s.hit);
    if (layer == row.last && s.hit && s.part_kind == kPartSolid)
        s.ink = row.solid_ink;
    s.hit = s.hit || hidden;
    s.covered = s.covered || hidden || s.part_kind == kPartTranslucent;
    return s;
}

#include "npr/screen_door.glsl"

// In screen-door: a surface of what is seen through is there or is not.
Surface with_door(Surface s, ivec2 pixel, vec3 ray) {
    float opacity = base_color(s).a;
    if (s.part_kind != kPartTranslucent || s.leaving || opacity <= 0.0f)
        return s;
    if (opacity >= 1.0f || behind_door(s, opacity, pixel, ray))
        s.color.a = 1.0f;
    else
        s.covered = true;
    return s;
}

// A layer of what is seen.
Surface seen_surface(ivec2 pixel, int layer, vec3 ray) {
    Surface s = layer_surface(pixel, layer, ray);
    if (s.hit && transparency != kSorted)
        s.covered = is_medium(s.part) || shared_with_another(s, pixel, layer, ray);
    if (transparency == kViewDependent)
        s = shone_through(s, pixel, layer);
    if (transparency == kScreenDoor && s.hit && !s.covered)
        s = with_door(s, pixel, ray);
    return s;
}

// The media that hold the eye: those whose first surface is one where the ray leaves. Others may go on behind the last
// layer that there is.
Media media_at_eye(ivec2 pixel) {
    Media m = no_media(view.depth_range.z > 0.5f ? view.depth_range.x : 0.0f);
    if (transparency != kVolume)
        return m;
    for (int i = 0; i < layer_count; ++i) {
        uvec2 ids = surface_ids(pixel, i);
        if (ids.x == kNoSurface)
            break;
        uint part = leaf_rows[leaf_of(ids)].part.x;
        bool first = is_leaving(ids);
        for (int j = i - 1; j >= 0 && first; --j)
            first = leaf_rows[leaf_of(surface_ids(pixel, j))].part.x != part;
        if (first)
            m = crossed(m, medium_rows[part].high, medium_rows[part].low, false);
    }
    return m;
}

// Is it where a ray enters a medium, which has no color of its own?
bool bounds_medium(Surface s) {
    return is_medium(s.part) && !s.leaving;
}

// What is seen up to a surface.
Composite reached(Composite c, Media m, Surface s, vec3 ray) {
    if (transparency != kVolume || !s.hit)
        return c;
    float facing = dot(normalize(mat3(view.eye_from_world) * ray), kLightDirection);
    float light = medium_light.x + medium_light.y * rayleigh(facing);
    return through_medium(c, density(m, medium_unit), light, (view_distance(s.depth) - m.at) * length(ray));
}

Media beyond(Media m, Surface s) {
    if (transparency != kVolume || !s.hit)
        return m;
    m.at = view_distance(s.depth);
    return crossed(m, medium_rows[s.part].high, medium_rows[s.part].low, s.leaving);
}
