// Surfaces continued by their planes: on a plane, depth is an affine function of the pixel.
#include "npr/frame.glsl"

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

bool in_picture(ivec2 pixel) {
    return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, textureSize(layer_depths, 0).xy));
}

const float kSmooth = 0.83;  // cosine between the normals of neighbouring facets of a smooth surface, at least

// Do the surfaces, `t` in the pixel at `offset` from that of `s`, meet where they are seen? `here` and `there`: how much
// nearer the first one's plane is than the other's. Where the planes meet between the two pixels the signs differ.
// Planes of a curved surface's facets may meet a little outside, or beside, where there are others between.
bool meet(Surface s, vec2 gradient, Surface t, vec2 other, ivec2 offset, float cosine, out float here, out float there) {
    here = s.depth - (t.depth - dot(other, vec2(offset)));
    there = s.depth + dot(gradient, vec2(offset)) - t.depth;
    float apart = min(abs(here), abs(there)) - 1e-6 * s.depth;
    float slack = cosine > kSmooth ? 3.0 * length(gradient - other) : abs(there - here);
    return here * there <= 0.0 || apart <= slack;
}

// The first layer of a pixel that lies in a plane, seen from one side (plane << 1 | leaving); -1: none.
int layer_of(ivec2 p, uint key) {
    for (int j = 0; j < layer_count; ++j) {
        uvec2 ids = texelFetch(layer_surfaces, ivec3(p, j), 0).xy;
        if (ids.x == kNoSurface)
            break;
        if (ids.y == key)
            return j;
    }
    return -1;
}

// How a surface goes on in a neighbouring pixel.
struct Continuation {
    bool found;    // false: it ends
    int layer;     // there
    float cosine;  // between the normals
    float at;      // where the planes meet, as a part of the way
    vec2 across;   // direction in the picture across the line in which they meet
};

// In its own plane. `offset`: of the neighbour. Both pixels must be in the picture.
Continuation straight_on(Surface s, ivec2 pixel, ivec2 offset) {
    int layer = layer_of(pixel + offset, s.plane << 1 | uint(s.leaving));
    if (layer < 0)
        return Continuation(false, 0, -2.0, 0.5, vec2(offset));
    return Continuation(true, layer, 1.0, 0.5, vec2(offset));
}

// In another plane.
Continuation round_the_bend(Surface s, ivec2 pixel, ivec2 offset) {
    Continuation c = Continuation(false, 0, -2.0, 0.5, vec2(offset));
    ivec2 p = pixel + offset;
    vec2 gradient = depth_gradient(s.plane);
    vec3 ray = pixel_ray(p);
    for (int j = 0; j < layer_count; ++j) {
        Surface t = layer_surface(p, j, ray);
        if (!t.hit)
            break;
        float cosine = dot(s.normal, t.normal);
        if (t.leaving != s.leaving || cosine <= c.cosine)
            continue;
        vec2 other = depth_gradient(t.plane);
        float here, there;
        // A plane that is seen on both sides goes on, and is no continuation of another.
        if (meet(s, gradient, t, other, offset, cosine, here, there) &&
            layer_of(pixel, t.plane << 1 | uint(t.leaving)) < 0) {
            float sum = abs(here) + abs(there);
            c.found = true;
            c.layer = j;
            c.cosine = cosine;
            c.at = here * there > 0.0 || sum == 0.0 ? 0.5 : abs(here) / sum;
            c.across = gradient - other;
        }
    }
    return c;
}

Continuation continuation(Surface s, ivec2 pixel, ivec2 offset) {
    Continuation c = straight_on(s, pixel, offset);
    if (!c.found)
        c = round_the_bend(s, pixel, offset);
    return c;
}
