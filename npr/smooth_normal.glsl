// Normals of the smooth surfaces that facets stand for (layers/smooth_facets.h). Valid in shaders and, within a struct
// with the same names, in C++.

// Where the ray of a pixel's sample meets a plane: in the world, from local_center.
vec3 point_on(uint plane, ivec2 pixel) {
    vec4 row = eye_plane(plane);
    vec3 normal = vec3(row);
    float offset = row.w;
    vec2 at = picture_position(pixel);
    vec3 here = view.depth_range.z > 0.5f ? vec3(at, (offset - dot(vec2(normal), at)) / normal.z)
                                          : vec3(at, -1.0f) * (offset / dot(normal, vec3(at, -1.0f)));
    return (here - center_in_eye) * mat3(view.eye_from_world);
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
    CornerNormals corners = corner_normals(nearest);
    vec3 n = shares.x * corners.first + shares.y * corners.second + shares.z * corners.third;
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
