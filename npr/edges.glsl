// The edge map of layers: profile edges, where a surface ends, and inner edges (creases), where it bends. Unlike the
// edge map of Nienhaus (2005), chapter 4, which compares depths and normals with thresholds, surfaces are continued by
// their planes: depth is an affine function of the pixel on each plane, so a slanted face gives no false edge, and a
// surface is found again in the neighbour whatever its layer is there.
#include "npr/frame.glsl"

uniform float crease_cosine;  // of the angle between normals from which a bend is an inner edge
uniform bool part_edges;      // boundaries of parts within a plane are inner edges

struct Edge {
    float profile;  // coverage of the pixel by the line, in [0, 1]
    float inner;
};

// Derivative of depth by the pixel's coordinates, on the plane.
vec2 depth_gradient(uint plane) {
    vec4 row = plane_rows[plane];
    vec3 n = mat3(view.eye_from_world) * row.xyz;
    float offset = row.w + dot(n, centre_in_eye);
    float scale = 2.0 * view.picture.z / view.picture.y;
    if (view.depth_range.z > 0.5)  // t = (n.xy * at - offset) / n.z, depth = (far - t) / (far - near)
        return -scale * n.xy / (n.z * (view.depth_range.y - view.depth_range.x));
    return scale * view.depth_range.x * n.xy / offset;  // 1 / t = dot(n, vec3(at, -1)) / offset, depth = near / t
}

// How the surface goes on in the neighbour at `offset`: bend -1: it ends; 0: it goes on; 1: it bends, `at` of the way.
int continuation(Surface s, vec2 gradient, ivec2 pixel, ivec2 offset, out float at) {
    at = 0.5;
    ivec2 p = pixel + offset;
    ivec2 size = textureSize(layer_depths, 0).xy;
    if (any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, size)))
        return 0;  // the picture's border is no edge
    uint key = s.plane << 1 | uint(s.leaving);
    for (int j = 0; j < layer_count; ++j) {
        uvec2 ids = texelFetch(layer_surfaces, ivec3(p, j), 0).xy;
        if (ids.x == 0xffffffffu)
            break;
        if (ids.y == key)
            return part_edges && leaf_rows[ids.x >> 1].part.x != s.part ? 1 : 0;
    }
    vec3 ray = pixel_ray(p);
    float best = -2.0;
    for (int j = 0; j < layer_count; ++j) {
        Surface t = layer_surface(p, j, ray);
        if (!t.hit)
            break;
        if (t.leaving != s.leaving)
            continue;
        // How much nearer this surface's plane is than the other's, here and there. Where the planes meet between the
        // two pixels the signs differ. Planes of a curved surface's facets may meet a little outside.
        vec2 other = depth_gradient(t.plane);
        float here = s.depth - (t.depth - dot(other, vec2(offset)));
        float there = s.depth + dot(gradient, vec2(offset)) - t.depth;
        float apart = min(abs(here), abs(there)) - 1e-6 * s.depth;
        if (here * there > 0.0 && apart > abs(there - here))
            continue;
        float cosine = dot(s.normal, t.normal);
        if (cosine > best) {
            best = cosine;
            float sum = abs(here) + abs(there);
            at = here * there > 0.0 || sum == 0.0 ? 0.5 : abs(here) / sum;
        }
    }
    if (best < -1.5)
        return -1;
    return best < crease_cosine ? 1 : 0;
}

// Lines `width` pixels wide: profile edges lie on the side of the surface that ends, inner edges on both sides.
Edge surface_edge(Surface s, ivec2 pixel, float width) {
    Edge edge = Edge(0.0, 0.0);
    vec2 gradient = depth_gradient(s.plane);
    int radius = int(ceil(width));
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) {
            ivec2 offset = ivec2(x, y);
            float distance = length(vec2(offset));
            // The outline is taken to be half a pixel before the first pixel without the surface.
            float profile = clamp(width - distance + 1.0, 0.0, 1.0);
            if (distance == 0.0 || profile <= max(edge.profile, 0.02))
                continue;
            float at;
            int bend = continuation(s, gradient, pixel, offset, at);
            if (bend < 0)
                edge.profile = profile;
            else if (bend > 0)
                edge.inner = max(edge.inner, clamp(0.5 * width - at * distance + 0.5, 0.0, 1.0));
        }
    return edge;
}
