// What is an edge, and where (npr/edges/edge_map.h). Valid in shaders and, within a struct with the same names, in C++.

float angle_between(float cosine) {
    return acos(clamp(cosine, -1.0f, 1.0f));
}

// The angle by which the surface bends on the way on from `pixel`; 0 where it ends.
float bend_ahead(ivec2 pixel, int layer, ivec2 offset) {
    if (!in_picture(pixel + offset))
        return 0.0f;
    Continuation c = continuation_at(pixel, layer, offset);
    return c.found ? angle_between(c.cosine) : 0.0f;
}

// Where a curved surface turns away from the eye, neighboring pixels see facets that are not neighbors, and the angle
// between them grows beyond that of facets. It is told from a crease by the bends on both sides of it. Surfaces of one
// leaf are known, and need no such care.
bool is_crease(Surface s, ivec2 p, int layer, ivec2 q, Continuation c) {
    Surface t = layer_surface(q, c.layer, pixel_ray(q));
    float limit = crease_limit(s, t);
    if (limit >= kNever)
        return false;
    float angle = angle_between(c.cosine);
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
    if (!in_picture(p - axis) || !in_picture(p + axis))
        return false;
    uvec2 before = surface_ids(p - axis, layer);
    uvec2 after = surface_ids(p + axis, layer);
    if (before.x == kNoSurface || after.x == kNoSurface || leaf_of(before) == leaf_of(after) ||
        is_leaving(before) != is_leaving(after) || plane_of(before) == u.plane || plane_of(after) == u.plane)
        return false;
    Surface s = layer_surface(p - axis, layer, pixel_ray(p - axis));
    Surface t = layer_surface(p + axis, layer, pixel_ray(p + axis));
    return bend_of(groups_of(s.plane, s.leaf)) > 0.0f && bend_of(groups_of(t.plane, t.leaf)) > 0.0f &&
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
    return meet(nearer(s.depth, gradient, t.depth, other, ivec2(0)), s, gradient, other, dot(s.normal, t.normal));
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
// layer: the silhouette is where front meets back.
Outline other_side(Surface s, int layer, ivec2 p, vec3 ray, ivec2 offset) {
    Outline o;
    o.partner = -1;
    o.at = 0.5f;
    o.across = vec2(offset);
    o.beside = 1e30f;
    for (int other = max(layer - 1, 0); other <= layer + 1; ++other) {
        uvec2 ids = surface_ids(p, other);
        if (other == layer || ids.x == kNoSurface || is_leaving(ids) == s.leaving)
            continue;
        Surface t = layer_surface(p, other, ray);
        Meeting m = meeting(s, t, offset);
        if (m.beside < o.beside) {
            o.beside = m.beside;
            o.partner = other;
            o.at = m.at;
            o.across = normalize(m.apart);
        }
    }
    return o;
}

// The same, and where it meets a face seen edge-on, or so nearly that no ray hits it, its own border tells where.
Outline outline(Outline o, Surface s, int layer, ivec2 p, ivec2 offset) {
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
    Contour contour = contour_at(link);
    if (crosses) {
        contour = longer_contour(contour, kContourNear);
        if (follows(contour, link, exact))
            return o;
    }
    Straight border = straight_border(longer_contour(contour, kContour), link);
    o.at = border.at;
    if (o.beside > 3.0f || abs(dot(border.across, o.across)) < 0.8f)
        o.beside = 1e30f;
    o.across = border.across;
    return o;
}

// How thick what ends there is across the line, as a share of kThick.
float thickness_at(int layer, ivec2 p, ivec2 offset, vec2 across) {
    float most = kThick / max(abs(dot(across, vec2(offset))), 0.25f);
    float count = 1.0f;
    for (ivec2 q = p; count < most && in_picture(q - offset); q -= offset, count += 1.0f) {
        Continuation c = continuation_at(q, layer, -offset);
        if (!c.found)
            return count / most;
        layer = c.layer;
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
    e.other = -1;
    e.bends = false;
    e.point = edge_point(kInnerEdge, 1.0f, 0.5f, vec2(offset));
    vec3 ray = pixel_ray(p);
    Surface s = layer_surface(p, layer, ray);
    Continuation c = continuation_at(p, layer, offset);
    if (!c.found) {
        Outline o = other_side(s, layer, p, ray, offset);
        // Both sides of an outline end together, in one edge: that of the nearer layer.
        e.found = !(o.partner >= 0 && o.partner < layer && !continuation_at(p, o.partner, offset).found) &&
                  !is_overhang(s, p, layer);
        if (!e.found)
            return e;
        o = outline(o, s, layer, p, offset);
        e.point = edge_point(kProfileEdge, 1.0f, o.at, o.across);
        if (follow_borders)
            e.point.thickness = thickness_at(layer, p, offset, o.across);
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
