// Surfaces continued by their planes: on a plane, depth is an affine function of the pixel (npr/plane_lookup.glsl).
// Valid in shaders and, within a struct with the same names, in C++.

const float kSmooth = 0.83f;  // cosine between the normals of neighboring facets of a smooth surface, at least

// How much nearer a surface's plane is than another's that is seen at `offset`: at its own pixel (x), and there (y).
// Where the planes meet between the two pixels the signs differ.
vec2 nearer(float depth, vec2 gradient, float other_depth, vec2 other, ivec2 offset) {
    return vec2(depth - (other_depth - dot(other, vec2(offset))), depth + dot(gradient, vec2(offset)) - other_depth);
}

// Are planes so far apart that their surfaces do not meet, however they are turned to each other? See meet.
bool far_apart(vec2 gap, float depth, vec2 gradient, vec2 other) {
    vec2 steps = abs(gradient - other);
    return gap.x * gap.y > 0.0f && min(abs(gap.x), abs(gap.y)) - 1e-6f * depth > 3.0f * (steps.x + steps.y);
}

// Do the surfaces meet where they are seen? Planes of a curved surface's facets may meet a little outside, or beside,
// where there are others between.
bool meet(vec2 gap, Surface s, vec2 gradient, vec2 other, float cosine) {
    float apart = min(abs(gap.x), abs(gap.y)) - 1e-6f * s.depth;
    float slack = cosine > kSmooth ? 3.0f * length(gradient - other) : abs(gap.y - gap.x);
    return gap.x * gap.y <= 0.0f || apart <= slack;
}

// How a surface goes on in a neighboring pixel.
struct Continuation {
    bool found;    // false: it ends
    int layer;     // there
    float cosine;  // between the normals
    float at;      // where the planes meet, as a part of the way
    vec2 across;   // direction in the picture across the line in which they meet
};

Continuation it_ends(ivec2 offset) {
    Continuation c;
    c.found = false;
    c.layer = 0;
    c.cosine = -2.0f;
    c.at = 0.5f;
    c.across = vec2(offset);
    return c;
}

// In its own plane. `offset`: of the neighbor. Both pixels must be in the picture.
Continuation straight_on(Surface s, ivec2 pixel, ivec2 offset) {
    Continuation c = it_ends(offset);
    int layer = layer_of(pixel + offset, plane_word(s.plane, s.leaving));
    if (layer >= 0) {
        c.found = true;
        c.layer = layer;
        c.cosine = 1.0f;
    }
    return c;
}

// In another plane.
Continuation round_the_bend(Surface s, ivec2 pixel, ivec2 offset) {
    Continuation c = it_ends(offset);
    ivec2 p = pixel + offset;
    vec2 gradient = depth_gradient(s.plane);
    vec3 ray = pixel_ray(p);
    for (int j = 0; j < layer_count; ++j) {
        uvec2 ids = surface_ids(p, j);
        if (ids.x == kNoSurface)
            break;
        if (is_leaving(ids) != s.leaving)
            continue;
        vec2 other = depth_gradient(plane_of(ids));
        vec2 gap = nearer(s.depth, gradient, layer_depth(p, j), other, offset);
        if (far_apart(gap, s.depth, gradient, other))
            continue;
        Surface t = layer_surface(p, j, ray);
        float cosine = dot(s.normal, t.normal);
        if (cosine <= c.cosine)
            continue;
        // A plane that is seen on both sides goes on, and is no continuation of another.
        if (meet(gap, s, gradient, other, cosine) && layer_of(pixel, plane_word(t.plane, t.leaving)) < 0) {
            float sum = abs(gap.x) + abs(gap.y);
            c.found = true;
            c.layer = j;
            c.cosine = cosine;
            c.at = gap.x * gap.y > 0.0f || sum == 0.0f ? 0.5f : abs(gap.x) / sum;
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
