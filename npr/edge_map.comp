// Finds the edges of the listed surfaces on their links (npr/edge_map.h). Profile edges win over inner edges.
#include "npr/edge_point.glsl"
#include "npr/planes.glsl"

uniform float crease_angle;  // between normals, from which a bend is an inner edge
uniform bool part_edges;     // boundaries of parts and colors on smooth surfaces are inner edges

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Candidates {
    uint candidate_count;
    uint candidate_room;
    uvec2 candidates[];
};
layout(r32ui, binding = 0) uniform uimage2DArray edge_points;
layout(r32ui, binding = 1) uniform uimage2D edge_marks;
layout(r32ui, binding = 2) uniform uimage2D edge_tiles;

float angle_between(float cosine) {
    return acos(clamp(cosine, -1.0, 1.0));
}

// The angle by which the surface bends on the way on from `pixel`; 0 where it ends.
float bend_ahead(ivec2 pixel, int layer, ivec2 offset) {
    if (!in_picture(pixel + offset))
        return 0.0;
    Continuation c = continuation(layer_surface(pixel, layer, pixel_ray(pixel)), pixel, offset);
    return c.found ? angle_between(c.cosine) : 0.0;
}

// Where a curved surface turns away from the eye, neighbouring pixels see facets that are not neighbours, and the angle
// between them grows beyond that of facets. It is told from a crease by the bends on both sides of it.
bool is_crease(ivec2 p, int layer, ivec2 q, Continuation c) {
    float angle = angle_between(c.cosine);
    if (angle <= crease_angle)
        return false;
    float curved = 0.5 * crease_angle;
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
    Outline o = Outline(-1, 0.5, vec2(offset));
    float best = 1e30;
    for (int other = max(layer - 1, 0); other <= layer + 1; ++other) {
        Surface t = layer_surface(p, other, ray);
        if (other == layer || !t.hit || t.leaving == s.leaving)
            continue;
        vec2 apart = depth_gradient(s.plane) - depth_gradient(t.plane);
        if (apart == vec2(0.0))
            continue;
        // Nearly along the line in which they meet, the point of the link tells little, and matters little.
        float closing = dot(apart, vec2(offset));
        float gap = t.depth - s.depth;
        float at = abs(closing) > 1e-3 * length(apart) ? gap / closing : 0.5;
        float beside = abs(gap - clamp(at, 0.0, 1.0) * closing) / length(apart);  // in pixels
        if (beside < best) {
            best = beside;
            // On curved surfaces front and back need not be neighbours.
            o = Outline(other, at < -0.1 || at > 2.0 ? 0.5 : clamp(at, 0.0, 1.0), normalize(apart));
        }
    }
    return o;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= min(candidate_count, candidate_room))
        return;
    int axis = link_axis(candidates[i].x);
    ivec2 lower = link_lower(candidates[i].x, textureSize(layer_depths, 0).x);
    int layer = int(candidates[i].y >> 1);
    bool upper = (candidates[i].y & 1u) != 0u;
    ivec2 offset = ivec2(1 - axis, axis);
    ivec2 p = upper ? lower + offset : lower;
    if (upper)
        offset = -offset;

    vec3 ray = pixel_ray(p);
    Surface s = layer_surface(p, layer, ray);
    Continuation c = continuation(s, p, offset);
    EdgePoint e;
    int at_layer = layer;
    if (!c.found) {
        Outline o = outline(s, layer, p, ray, offset);
        // Both sides of an outline end together, in one edge: that of the nearer layer.
        if (o.partner >= 0 && o.partner < layer &&
            !continuation(layer_surface(p, o.partner, ray), p, offset).found)
            return;
        e = EdgePoint(kProfileEdge, 1.0, o.at, o.across);
    } else {
        bool bends = is_crease(p, layer, p + offset, c);
        if (!bends && part_edges) {
            bends = !look_alike(s.leaf, texelFetch(layer_surfaces, ivec3(p + offset, c.layer), 0).x >> 1);
        }
        if (!bends)
            return;
        at_layer = min(layer, c.layer);
        float size = length(c.across);
        e = EdgePoint(kInnerEdge, 1.0, c.at, size > 0.0 ? c.across / size : vec2(offset));
    }
    if (upper)
        e.at = 1.0 - e.at;
    imageAtomicMax(edge_points, ivec3(lower, edge_slice(at_layer, axis)), pack_edge(e));
    uint mark = edge_mark(at_layer, axis);
    imageAtomicOr(edge_marks, lower, mark);
    imageAtomicOr(edge_tiles, lower / kEdgeTile, mark);
}
