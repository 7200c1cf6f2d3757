// Noise with an explicit seed: hashes of integer points, and Perlin's gradient noise between them.

uvec3 hash(uvec3 v) {  // PCG in three dimensions (Jarzynski and Olano 2020)
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

// In [0, 1), three independent values.
vec3 white_noise(ivec2 at, uint seed) {
    return vec3(hash(uvec3(uvec2(at), seed)) >> 8) / 16777216.0;
}

float corner(ivec3 cell, vec3 from_corner, uint seed) {
    vec3 gradient = vec3(hash(uvec3(cell) + uvec3(0u, 0u, seed * 7919u)) >> 8) / 8388608.0 - 1.0;
    return dot(gradient, from_corner);
}

// Smooth, about -1 to 1, mean 0; features about 1 apart.
float perlin_noise(vec3 p, uint seed) {
    vec3 low = floor(p);
    ivec3 cell = ivec3(low);
    vec3 f = p - low;
    vec3 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec4 near = vec4(corner(cell, f, seed), corner(cell + ivec3(1, 0, 0), f - vec3(1, 0, 0), seed),
                     corner(cell + ivec3(0, 1, 0), f - vec3(0, 1, 0), seed),
                     corner(cell + ivec3(1, 1, 0), f - vec3(1, 1, 0), seed));
    vec4 far = vec4(corner(cell + ivec3(0, 0, 1), f - vec3(0, 0, 1), seed),
                    corner(cell + ivec3(1, 0, 1), f - vec3(1, 0, 1), seed),
                    corner(cell + ivec3(0, 1, 1), f - vec3(0, 1, 1), seed),
                    corner(cell + ivec3(1, 1, 1), f - vec3(1, 1, 1), seed));
    vec4 z = mix(near, far, w.z);
    vec2 y = mix(z.xy, z.zw, w.y);
    return 1.3 * mix(y.x, y.y, w.x);
}
