// View-dependent transparency (Diepstraten, Weiskopf and Ertl 2002): only faces toward the eye shine, opaque parts show
// through the nearest of them only, and nothing that is seen through shows through another. Valid in shaders and, within
// a struct with the same names, in C++.

const int kNothingHides = 1 << 30;  // ShineRow::last where all there is may show

// Does the part have a surface in this plane there, seen from this side?
bool part_is_in(ivec2 pixel, uint part, uint word) {
    for (int j = 0; j < layer_count; ++j) {
        uvec2 ids = surface_ids(pixel, j);
        if (ids.x == kNoSurface)
            break;
        if (ids.y == word && leaf_rows[leaf_of(ids)].part.x == part)
            return true;
    }
    return false;
}

// Does the surface go on in a neighboring pixel, in its own plane or beyond a bend, as one of its part? Where it does
// not, its silhouette lies between the two.
bool part_goes_on(Surface s, ivec2 pixel, ivec2 offset) {
    ivec2 p = pixel + offset;
    if (part_is_in(p, s.part, plane_word(s.plane, s.leaving)))
        return true;
    vec2 gradient = depth_gradient(s.plane);
    vec3 ray = pixel_ray(p);
    for (int j = 0; j < layer_count; ++j) {
        Surface t = layer_surface(p, j, ray);
        if (!t.hit)
            break;
        if (t.leaving != s.leaving || t.part != s.part)
            continue;
        vec2 other = depth_gradient(t.plane);
        vec2 gap = nearer(s.depth, gradient, t.depth, other, offset);
        if (meet(gap, s, gradient, other, dot(s.normal, t.normal)) &&
            !part_is_in(pixel, s.part, plane_word(t.plane, t.leaving)))
            return true;
    }
    return false;
}

// Of a surface: its part, and whether a silhouette of the part is next to it. What lies beyond the picture is not known.
uint shine_key(Surface s, ivec2 pixel) {
    bool ends = false;
    for (int i = 0; i < 4 && !ends; ++i) {
        ivec2 offset = i < 2 ? ivec2(2 * i - 1, 0) : ivec2(0, 2 * i - 5);
        ends = in_picture(pixel + offset) && !part_goes_on(s, pixel, offset);
    }
    return (s.part + 1u) << 1 | (ends ? 1u : 0u);
}

// `stop_at_back`: method I.
ShineSource shine_source(ivec2 pixel, bool stop_at_back) {
    ShineSource r;
    r.front = -1;
    r.last = kNothingHides;
    r.front_key = 0u;
    r.solid_key = 0u;
    vec3 ray = pixel_ray(pixel);
    float front_depth = 0.0f;
    for (int i = 0; i < layer_count && r.last == kNothingHides; ++i) {
        Surface s = layer_surface(pixel, i, ray);
        if (!s.hit)
            break;
        if (s.part_kind == kPartSolid) {
            r.last = i;
            r.solid_key = shine_key(s, pixel);
        } else if (s.part_kind == kPartTranslucent && base_color(s).a > 0.0f) {
            if (r.front < 0) {
                if (!s.leaving && !shared_with_another(s, pixel, i, ray)) {
                    r.front = i;
                    front_depth = s.depth;
                    r.front_key = shine_key(s, pixel);
                }
            } else if (s.leaving ? stop_at_back : s.depth != front_depth) {
                r.last = i;
            }
        }
    }
    return r;
}
