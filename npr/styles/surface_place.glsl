// Places on surfaces, for what is anchored on the model. Valid in shaders and, within a struct with the same names, in
// C++.

#include "npr/smooth_normal.glsl"

// Where a pixel's sample and its neighbors to the right and above see one plane: world coordinates from local_center.
struct Place {
    vec3 here;
    vec3 right;  // from here
    vec3 above;
};

vec3 point_of(vec3 normal, float offset, vec2 at) {
    if (view.depth_range.z > 0.5f)
        return vec3(at, (offset - dot(vec2(normal), at)) / normal.z);
    return vec3(at, -1.0f) * (offset / dot(normal, vec3(at, -1.0f)));
}

Place place_on(uint plane, ivec2 pixel) {
    mat3 turn = mat3(view.eye_from_world);
    vec4 row = plane_rows[plane];
    vec3 normal = turn * vec3(row);
    float offset = row.w + dot(normal, center_in_eye);
    vec3 here = point_of(normal, offset, picture_position(pixel));
    Place p;
    p.here = (here - center_in_eye) * turn;
    p.right = (point_of(normal, offset, picture_position(pixel + ivec2(1, 0))) - here) * turn;
    p.above = (point_of(normal, offset, picture_position(pixel + ivec2(0, 1))) - here) * turn;
    return p;
}

// Gradient of a coordinate of the world by the pixel.
vec2 rate(Place p, vec3 direction) {
    return vec2(dot(p.right, direction), dot(p.above, direction));
}

// Of a leaf: a unit vector along its z axis, about which cylinders, cones, spheres and what is extruded go around.
vec3 axis_of(uint leaf) {
    uint bits = leaf_rows[leaf].part.w;
    return from_octahedron((vec2(float(bits >> 2 & 32767u), float(bits >> 17 & 32767u)) - 16384.0f) / 16383.0f);
}

// Unit vectors across a leaf's axis, and across each other.
vec3 across_axis(vec3 axis) {
    return normalize(cross(axis, abs(axis.z) < 0.9f ? vec3(0.0f, 0.0f, 1.0f) : vec3(1.0f, 0.0f, 0.0f)));
}

// How much of a surface ink is to cover, up to `most`, by one light: more where it is dark, or, where the ink is lighter
// than the paper, where it is lit.
float ink_tone(Surface s, float most) {
    float lit = max(dot(mat3(view.eye_from_world) * s.normal, kLightDirection), 0.0f);
    bool light_ink = dot(ink_color - paper_color, vec3(1.0f)) > 0.0f;
    return most * (light_ink ? 0.1f + 0.9f * lit : 1.0f - lit);
}
