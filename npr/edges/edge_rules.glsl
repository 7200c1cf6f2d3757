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

// Where a curved surface turns away from the eye, neighboring pixels see facets that are not neighbors, and the angle
// between them grows beyond that of facets. It is told from a crease by the bends on both sides of it. Surfaces of one
// leaf are known, and need no such care.
bool is_crease(Surface s, ivec2 p, int layer, ivec2 q, Continuation c) {
    float angle = angle_between(c.cosine);
    Surface t = layer_surface(q, c.layer, pixel_ray(q));
    float limit = crease_limit(s, t);
    if (angle <= limit)
        return false;
    if (limit == kLeastOfLeaf || (s.leaf != t.leaf && angle > limit + kCurved))
        return true;
    ivec2 offset = q - p;
    float before = bend_ahead(p, layer, -offset);
    float after = bend_ahead(q, c.layer, offset);
    // Within a surface a crease stands out among what is beside it.
    return s.leaf == t.leaf ? angle > 2.0f * max(before, after) : angle > limit + min(2.0f * min(before, after), kCurved);
}

bool bends_by_crease(Surface s, Surface t) {
    return angle_between(dot(s.normal, t.normal)) > crease_limit(s, t);
}

// Is the surface of a pixel what is left of a face that is hidden but for the difference of two tessellations? It lies
// between curved surfaces of two leaves that go on in each other.
bool is_sliver(Surface u, ivec2 p, int layer, ivec2 axis) {
    Surface s = layer_surface(p - axis, layer, pixel_ray(p - axis));
    Surface t = layer_surface(p + axis, layer, pixel_ray(p + axis));
    return s.hit && t.hit && s.leaf != t.leaf && s.leaving == t.leaving && u.plane != s.plane && u.plane != t.plane &&
           bend_of(groups_of(s.plane, s.leaf)) > 0.0f && bend_of(groups_of(t.plane, t.leaf)) > 0.0f &&
           !bends_by_crease(s, t) && bends_by_crease(s, u) && bends_by_crease(t, u);
}

// Does a surface stand out before another leaf's that goes on in it, by no more than their tessellations differ?
bool is_overhang(Surface s, ivec2 p, int layer) {
    Surface t = layer_surface(p, layer + 2, pixel_ray(p));
    if (!t.hit || s.leaf == t.leaf || s.leaving != t.leaving || bend_of(groups_of(s.plane, s.leaf)) == 0.0f ||
        bend_of(groups_of(t.plane, t.leaf)) == 0.0f || bends_by_crease(s, t))
        return false;
    vec2 gradient = depth_gradient(s.plane);
    vec2 other = depth_gradient(t.plane);
    return meet(nearer(s, gradient, t, other, ivec2(0)), s, gradient, other, dot(s.normal, t.normal));
}

bool at_sliver(Surface s, ivec2 p, int layer, ivec2 q, int other) {
    Surface t = layer_surface(q, other, pixel_ray(q));
    return is_sliver(s, p, layer, ivec2(1, 0)) || is_sliver(s, p, layer, ivec2(0, 1)) ||
           is_sliver(t, q, other, ivec2(1, 0)) || is_sliver(t, q, other, ivec2(0, 1));
}

// Where the planes of two surfaces of a pixel meet, seen from the link to its neighbor.
struct Meeting {
    vec2 apart;    // across the line; 0: they do not meet
    float at;      // on the link
    float beside;  // pixels from the link to the line
};

Meeting meeting(Surface s, Surface t, ivec2 offset) {
    Meeting m;
    m.apart = depth_gradient(s.plane) - depth_gradient(t.plane);
    m.at = 0.5f;
    m.beside = 1e30f;
    if (m.apart == vec2(0.0f))
        return m;
    // Nearly along the line in which they meet, the point of the link tells little, and matters little.
    float closing = dot(m.apart, vec2(offset));
    float gap = t.depth - s.depth;
    m.at = abs(closing) > 1e-3f * length(m.apart) ? gap / closing : 0.5f;
    m.beside = abs(gap - clamp(m.at, 0.0f, 1.0f) * closing) / length(m.apart);
    return m;
}

struct Outline {
    int partner;  // layer; -1: none
    float at;
    vec2 across;
    float beside;  // pixels from the link to the line in which their planes meet
};

// A surface that ends does so where it meets the other side of the solid, or of the gap, which is the next or the last
// layer: the silhouette is where front meets back. Where it meets a face seen edge-on, or so nearly that no ray hits
// it, its own border tells where.
Outline outline(Surface s, int layer, ivec2 p, vec3 ray, ivec2 offset) {
    Outline o;
    o.partner = -1;
    o.at = 0.5f;
    o.across = vec2(offset);
    o.beside = 1e30f;
    for (int other = max(layer - 1, 0); other <= layer + 1; ++other) {
        Surface t = layer_surface(p, other, ray);
        if (other == layer || !t.hit || t.leaving == s.leaving)
            continue;
        Meeting m = meeting(s, t, offset);
        if (m.beside < o.beside) {
            o.beside = m.beside;
            o.partner = other;
            o.at = m.at;
            o.across = normalize(m.apart);
        }
    }
    if (!follow_borders) {
        o.at = o.at < -0.1f || o.at > 2.0f ? 0.5f : clamp(o.at, 0.0f, 1.0f);
        return o;
    }
    bool crosses = o.beside < 0.5f && o.at > -0.1f && o.at < 1.1f;
    o.at = clamp(o.at, 0.0f, 1.0f);
    // On curved surfaces front and back need not be neighbors: they may meet beside the border, about in parallel.
    if (crosses && bend_of(groups_of(s.plane, s.leaf)) == 0.0f)
        return o;
    EndLink link;
    link.found = true;
    link.pixel = p;
    link.layer = layer;
    link.offset = offset;
    Straight exact;
    exact.at = o.at;
    exact.across = o.across;
    if (crosses && follows(contour_about(link, kContourNear), link, exact))
        return o;
    Straight border = straight_border(contour_about(link, kContour), link);
    o.at = border.at;
    if (o.beside > 3.0f || abs(dot(border.across, o.across)) < 0.8f)
        o.beside = 1e30f;
    o.across = border.across;
    return o;
}

// How thick what ends there is across the line, as a share of kThick.
float thickness_at(Surface s, ivec2 p, ivec2 offset, vec2 across) {
    float most = kThick / max(abs(dot(across, vec2(offset))), 0.25f);
    float count = 1.0f;
    for (ivec2 q = p; count < most && in_picture(q - offset); q -= offset, count += 1.0f) {
        Continuation c = continuation(s, q, -offset);
        if (!c.found)
            return count / most;
        s = layer_surface(q - offset, c.layer, pixel_ray(q - offset));
    }
    return 1.0f;
}

struct FoundEdge {
    bool found;
    EdgePoint point;  // `at` from the pixel that was asked
    int layer;
    int other;   // layer of the surface beyond the edge: of the neighbor, or where a surface ends of the pixel itself
                 // (-1: unknown)
    bool bends;  // is it one by its angle?
};

// The edge of a surface of `p` on the way to its neighbor at `offset`. Both must be in the picture.
FoundEdge edge_of(int layer, ivec2 p, ivec2 offset) {
    FoundEdge e;
    e.found = true;
    e.layer = layer;
    e.bends = false;
    vec3 ray = pixel_ray(p);
    Surface s = layer_surface(p, layer, ray);
    Continuation c = continuation(s, p, offset);
    if (!c.found) {
        Outline o = outline(s, layer, p, ray, offset);
        // Both sides of an outline end together, in one edge: that of the nearer layer.
        if (o.partner >= 0 && o.partner < layer && !continuation(layer_surface(p, o.partner, ray), p, offset).found)
            e.found = false;
        if (is_overhang(s, p, layer))
            e.found = false;
        e.point = edge_point(kProfileEdge, 1.0f, o.at, o.across);
        if (e.found && follow_borders)
            e.point.thickness = thickness_at(s, p, offset, o.across);
        e.other = o.beside < 3.0f ? o.partner : -1;
        return e;
    }
    e.bends = is_crease(s, p, layer, p + offset, c) && !at_sliver(s, p, layer, p + offset, c.layer);
    e.found = e.bends || (part_edges && !look_alike(s.leaf, leaf_of(surface_ids(p + offset, c.layer))));
    e.other = c.layer;
    e.layer = min(layer, c.layer);
    float size = length(c.across);
    e.point = edge_point(kInnerEdge, 1.0f, c.at, size > 0.0f ? c.across / size : vec2(offset));
    return e;
}
