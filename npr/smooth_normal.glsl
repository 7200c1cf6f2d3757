// Normals of the smooth surfaces that facets stand for (layers/smooth_facets.h). Valid in shaders and, within a struct
// with the same names, in C++.

// Of a corner: zero at the tip of a cone.
vec3 corner_normal(uint bits) {
    if (bits == 0u)
        return vec3(0.0f);
    vec2 e = (vec2(float(bits & 0xffffu), float(bits >> 16)) - 32768.0f) / 32767.0f;
    vec3 v = vec3(e, 1.0f - abs(e.x) - abs(e.y));
    if (v.z < 0.0f) {
        float x = v.x;
        v.x = (1.0f - abs(v.y)) * (x < 0.0f ? -1.0f : 1.0f);
        v.y = (1.0f - abs(x)) * (v.y < 0.0f ? -1.0f : 1.0f);
    }
    return normalize(v);
}

// Where the ray of a pixel's sample meets a plane: in the world, from local_center.
vec3 point_on(uint plane, ivec2 pixel) {
    mat3 turn = mat3(view.eye_from_world);
    vec4 row = plane_rows[plane];
    vec3 normal = turn * vec3(row);
    float offset = row.w + dot(normal, center_in_eye);
    vec2 at = picture_position(pixel);
    vec3 here = view.depth_range.z > 0.5f ? vec3(at, (offset - dot(vec2(normal), at)) / normal.z)
                                          : vec3(at, -1.0f) * (offset / dot(normal, vec3(at, -1.0f)));
    return (here - center_in_eye) * turn;
}

// A little beside its triangle a point is still taken for one of it: planes of a table are not quite the triangles'.
const float kBesideFacet = -0.01f;

// That of the surface, at the place that the pixel sees of it.
vec3 smooth_normal(Surface s, ivec2 pixel) {
    uint begin = facet_start(s.plane);
    uint end = facet_start(s.plane + 1u);
    if (begin == end)
        return s.normal;
    vec3 at = point_on(s.plane, pixel);
    uint nearest = end;
    float inside = kBesideFacet;
    vec3 shares = vec3(0.0f);
    for (uint i = begin; i < end && inside < 0.0f; ++i) {
        SmoothFacet f = smooth_facets[i];
        float first = dot(vec3(f.first), at) + f.first.w;
        float second = dot(vec3(f.second), at) + f.second.w;
        float third = 1.0f - first - second;
        float least = min(min(first, second), third);
        if (f.normals.w == s.leaf && least > inside) {
            nearest = i;
            inside = least;
            shares = max(vec3(first, second, third), 0.0f);
        }
    }
    if (nearest == end)
        return s.normal;
    uvec4 corners = smooth_facets[nearest].normals;
    vec3 n = shares.x * corner_normal(corners.x) + shares.y * corner_normal(corners.y) +
             shares.z * corner_normal(corners.z);
    float size = length(n);
    if (size < 1e-5f)
        return s.normal;
    return dot(n, s.normal) < 0.0f ? -n / size : n / size;
}

// The surface as light falls on it.
Surface rounded(Surface s, ivec2 pixel) {
    if (smooth_shading && s.hit)
        s.normal = smooth_normal(s, pixel);
    return s;
}
