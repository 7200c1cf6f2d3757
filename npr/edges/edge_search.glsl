// The search where edges may be: surfaces of neighboring pixels, compared by their planes. Valid in shaders and, within
// a struct with the same names, in C++.

bool in_pixel(uvec2 a, ivec2 q, uint bits) {
    if ((bits & bit_of(a)) == 0u)
        return false;
    for (int j = 0; j < layer_count; ++j) {
        uvec2 b = surface_ids(q, j);
        if (b.x == kNoSurface)
            return false;
        if (same_surface(a, b))
            return true;
    }
    return false;
}

// Two neighboring facets of a curved surface, most often: no edge.
bool smooth_joint(ivec2 p, ivec2 q, int layer) {
    if (is_leaving(surface_ids(p, layer)) != is_leaving(surface_ids(q, layer)))
        return false;
    Surface s = layer_surface(p, layer, pixel_ray(p));
    Surface t = layer_surface(q, layer, pixel_ray(q));
    float cosine = dot(s.normal, t.normal);
    vec2 gradient = depth_gradient(s.plane);
    vec2 other = depth_gradient(t.plane);
    if ((part_edges && !look_alike(s.leaf, t.leaf)) ||
        !meet(nearer(s.depth, gradient, t.depth, other, q - p), s, gradient, other, cosine))
        return false;
    float limit = crease_limit(s, t);
    return limit >= kNever || acos(clamp(cosine, -1.0f, 1.0f)) <= limit;
}

// Calls add(link, layer, end) for the surfaces that do not go on in their own plane at the other end of the link from p
// to q: where edges may be. `end` is 1 for those of q. Gives the last such layer, -1 where there is none.
int search_link(uint link, ivec2 p, ivec2 q) {
    uint p_bits = surface_bits(p);
    uint q_bits = surface_bits(q);
    bool p_ahead = true;
    bool q_ahead = true;
    int last = -1;
    for (int layer = 0; layer < layer_count; ++layer) {
        uvec2 a = p_ahead ? surface_ids(p, layer) : uvec2(kNoSurface);
        uvec2 b = q_ahead ? surface_ids(q, layer) : uvec2(kNoSurface);
        p_ahead = a.x != kNoSurface && !(visible_only && opaque(a));
        q_ahead = b.x != kNoSurface && !(visible_only && opaque(b));
        if (a.x == kNoSurface && b.x == kNoSurface)
            break;
        if (a.x != kNoSurface && b.x != kNoSurface && same_surface(a, b))
            continue;
        bool a_ends = a.x != kNoSurface && !in_pixel(a, q, q_bits);
        bool b_ends = b.x != kNoSurface && !in_pixel(b, p, p_bits);
        if (a_ends && b_ends && smooth_joint(p, q, layer))
            continue;
        if (a_ends)
            add(link, layer, 0u);
        if (b_ends)
            add(link, layer, 1u);
        if (a_ends || b_ends)
            last = layer;
    }
    return last;
}
