// What rows of a frame's tables say, worked out. Valid in shaders, which do so each time, and within a struct with the same
// names in C++, which remembers it (npr/shader_frame.h).

// A plane in the eye's coordinates: its normal, and the offset along it.
vec4 plane_in_eye(uint plane) {
    vec4 row = plane_rows[plane];
    vec3 normal = mat3(view.eye_from_world) * vec3(row);
    return vec4(normal, row.w + dot(normal, center_in_eye));
}

// Of a facet's corners (layers/smooth_facets.h).
struct CornerNormals {
    vec3 first;
    vec3 second;
    vec3 third;
};

// A unit vector whose octahedron has been unfolded to a square from -1 to 1.
vec3 from_octahedron(vec2 e) {
    vec3 v = vec3(e, 1.0f - abs(e.x) - abs(e.y));
    if (v.z < 0.0f) {
        float x = v.x;
        v.x = (1.0f - abs(v.y)) * (x < 0.0f ? -1.0f : 1.0f);
        v.y = (1.0f - abs(x)) * (v.y < 0.0f ? -1.0f : 1.0f);
    }
    return normalize(v);
}

// Of a corner: zero at the tip of a cone.
vec3 corner_normal(uint bits) {
    if (bits == 0u)
        return vec3(0.0f);
    return from_octahedron((vec2(float(bits & 0xffffu), float(bits >> 16)) - 32768.0f) / 32767.0f);
}

CornerNormals normals_of_corners(uint facet) {
    uvec4 bits = smooth_facets[facet].normals;
    CornerNormals n;
    n.first = corner_normal(bits.x);
    n.second = corner_normal(bits.y);
    n.third = corner_normal(bits.z);
    return n;
}
