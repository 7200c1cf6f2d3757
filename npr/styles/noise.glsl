// Noise with an explicit seed: hashes of integer points, and Perlin's gradient noise between them. Valid in shaders
// and, within a struct, in C++.

uvec3 hash(uvec3 v) {  // PCG in three dimensions (Jarzynski and Olano 2020)
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

// In [0, 1), three independent values.
vec3 white_noise(ivec2 at, uint seed) {
    return vec3(hash(uvec3(uvec2(at), seed)) >> 8u) / 16777216.0f;
}

// The grain of paper, in [0, 1): it belongs to the pixel, whatever the sample.
float paper_grain(ivec2 pixel, uint seed) {
    return 0.55f * white_noise(pixel, seed + 77u).x + 0.45f * white_noise(pixel / 2, seed + 78u).x;
}

// Of the corners of a cell of the lattice: their places count x first, then y.
struct Gradients {
    vec3 low[4];   // at its lower z
    vec3 high[4];
};

vec3 gradient_of(ivec3 corner, uint seed) {
    return vec3(hash(uvec3(corner) + uvec3(0u, 0u, seed * 7919u)) >> 8u) / 8388608.0f - 1.0f;
}

Gradients gradients_about(ivec3 cell, uint seed) {
    Gradients g;
    for (int i = 0; i < 4; ++i) {
        g.low[i] = gradient_of(cell + ivec3(i & 1, i >> 1, 0), seed);
        g.high[i] = gradient_of(cell + ivec3(i & 1, i >> 1, 1), seed);
    }
    return g;
}

// In the cell, at `f` from its lowest corner.
float noise_between(Gradients g, vec3 f) {
    vec3 w = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
    vec4 z = vec4(dot(g.low[0], f), dot(g.low[1], f - vec3(1.0f, 0.0f, 0.0f)),
                  dot(g.low[2], f - vec3(0.0f, 1.0f, 0.0f)), dot(g.low[3], f - vec3(1.0f, 1.0f, 0.0f)));
    if (w.z > 0.0f)
        z = mix(z,
                vec4(dot(g.high[0], f - vec3(0.0f, 0.0f, 1.0f)), dot(g.high[1], f - vec3(1.0f, 0.0f, 1.0f)),
                     dot(g.high[2], f - vec3(0.0f, 1.0f, 1.0f)), dot(g.high[3], f - vec3(1.0f, 1.0f, 1.0f))),
                w.z);
    return 1.3f * mix(mix(z.x, z.y, w.x), mix(z.z, z.w, w.x), w.y);
}
