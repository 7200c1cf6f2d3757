// What is an edge, and where (npr/edges/edge_map.h). Valid in shaders and, within a struct with the same names, in C++.

float angle_between(float cosine) {
    return acos(clamp(cosine, -1.0f, 1.0f));
}

// The angle by which the surface bends on the way on from `pixel`; 0 where it ends.
float bend_ahead(ivec2 pixel, int layer, ivec2 offset) {
    if (!in_picture(pixel + offset))
        return 0.0f;
    Continuation c = continuation(layer_surface(pixel, layer, pixel_ray(pixel)), pixel, offset);
    return c.found ? angle_between(c.cosine) : 0.0f;
}

// Where a curved surface turns away from the eye, neighbouring pixels see facets that are not neighbours, and the angle
// between them grows beyond that of facets. It is told from a crease by the bends on both sides of it.
bool is_crease(ivec2 p, int layer, ivec2 q, Continuation c) {
    float angle = angle_between(c.cosine);
    if (angle <= crease_angle)
        return false;
    float curved = 0.5f * crease_angle;
    if (angle > crease_angle + curved)
        return true;
    ivec2 offset = q - p;
    return angle > crease_angle + min(bend_ahead(p, layer, -offset) + bend_ahead(q, c.layer, offset), curved);
}

struct Outline {
    int partner;  // layer; -1: none
    float at;
    vec2 across;
};

// A surface that ends does so where it meets the other side of the solid, or of the gap, which is the next or the last
// layer: the silhouette is where front meets back.
Outline outline(Surface s, int layer, ivec2 p, vec3 ray, ivec2 offset) {
    Outline o;
    o.partner = -1;
    o.at = 0.5f;
    o.across = vec2(offset);
    float best = 1e30f;
    for (int other = max(layer - 1, 0); other <= layer + 1; ++other) {
        Surface t = layer_surface(p, other, ray);
        if (other == layer || !t.hit || t.leaving == s.leaving)
            continue;
        vec2 apart = depth_gradient(s.plane) - depth_gradient(t.plane);
        if (apart == vec2(0.0f))
            continue;
        // Nearly along the line in which they meet, the point of the link tells little, and matters little.
        float closing = dot(apart, vec2(offset));
        float gap = t.depth - s.depth;
        float at = abs(closing) > 1e-3f * length(apart) ? gap / closing : 0.5f;
        float beside = abs(gap - clamp(at, 0.0f, 1.0f) * closing) / length(apart);  // in pixels
        if (beside < best) {
            best = beside;
            o.partner = other;
            // On curved surfaces front and back need not be neighbours.
            o.at = at < -0.1f || at > 2.0f ? 0.5f : clamp(at, 0.0f, 1.0f);
            o.across = normalize(apart);
        }
    }
    return o;
}

struct FoundEdge {
    bool found;
    EdgePoint point;  // `at` from the pixel that was asked
    int layer;
};

// The edge of a surface of `p` on the way to its neighbour at `offset`. Both must be in the picture.
FoundEdge edge_of(int layer, ivec2 p, ivec2 offset) {
    FoundEdge e;
    e.found = true;
    e.layer = layer;
    vec3 ray = pixel_ray(p);
    Surface s = layer_surface(p, layer, ray);
    Continuation c = continuation(s, p, offset);
    if (!c.found) {
        Outline o = outline(s, layer, p, ray, offset);
        // Both sides of an outline end together, in one edge: that of the nearer layer.
        if (o.partner >= 0 && o.partner < layer && !continuation(layer_surface(p, o.partner, ray), p, offset).found)
            e.found = false;
        e.point = edge_point(kProfileEdge, 1.0f, o.at, o.across);
        return e;
    }
    bool bends = is_crease(p, layer, p + offset, c);
    if (!bends && part_edges)
        bends = !look_alike(s.leaf, leaf_of(surface_ids(p + offset, c.layer)));
    e.found = bends;
    e.layer = min(layer, c.layer);
    float size = length(c.across);
    e.point = edge_point(kInnerEdge, 1.0f, c.at, size > 0.0f ? c.across / size : vec2(offset));
    return e;
}
