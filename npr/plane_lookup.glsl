// What is asked of planes, and of the planes that a pixel sees. Valid in shaders and, within a struct with the same
// names, in C++; npr/painter/cpu_edges.cpp remembers some of it.

// Derivative of depth by the pixel's coordinates, on the plane.
vec2 depth_gradient(uint plane) {
    vec4 row = eye_plane(plane);
    vec3 n = vec3(row);
    float offset = row.w;
    float scale = 2.0f * view.picture.z / view.picture.y;
    if (view.depth_range.z > 0.5f)  // t = (n.xy * at - offset) / n.z, depth = (far - t) / (far - near)
        return -scale * vec2(n) / (n.z * (view.depth_range.y - view.depth_range.x));
    return scale * view.depth_range.x * vec2(n) / offset;  // 1 / t = dot(n, vec3(at, -1)) / offset, depth = near / t
}

uint bit_of(uvec2 ids) {
    return 1u << (ids.y * 2654435769u >> 27);
}

// The surfaces of a pixel, one bit each; different ones may share a bit.
uint surface_bits(ivec2 p) {
    uint bits = 0u;
    for (int i = 0; i < layer_count; ++i) {
        uvec2 ids = surface_ids(p, i);
        if (ids.x == kNoSurface)
            break;
        bits |= bit_of(ids);
    }
    return bits;
}

// The first layer of a pixel that lies in a plane, seen from one side (`key`: plane_word); -1: none.
int layer_of(ivec2 p, uint key) {
    for (int j = 0; j < layer_count; ++j) {
        uvec2 ids = surface_ids(p, j);
        if (ids.x == kNoSurface)
            break;
        if (ids.y == key)
            return j;
    }
    return -1;
}
