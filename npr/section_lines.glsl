// Hatching of the faces that sections leave, as in technical drawings: lines at 45 degrees, at other angles in parts
// that are next to each other, anchored on the model. Valid in shaders and, within a struct with the same names, in C++.

const float kHatchingWidth = 1.2f;  // pixels

bool is_section(uint leaf) {
    return section_spacing > 0.0f && leaf_rows[leaf].part.z != 0u;
}

// Angle of the lines in the drawing of the face, as a unit vector. `hatching`: 1 to 6.
vec2 hatching_direction(uint hatching) {
    float degrees = hatching == 1u   ? 45.0f
                    : hatching == 2u ? 135.0f
                    : hatching == 3u ? 30.0f
                    : hatching == 4u ? 120.0f
                    : hatching == 5u ? 60.0f
                                     : 150.0f;
    return vec2(cos(radians(degrees)), sin(radians(degrees)));
}

// Unit vector in a plane across the lines, world coordinates. Of a face that stands, the z axis is up in its drawing,
// of one that lies, the y axis.
vec3 across_hatching(vec3 normal, uint hatching) {
    vec3 up = abs(normal.z) > 0.999f ? vec3(0.0f, 1.0f, 0.0f) : vec3(0.0f, 0.0f, 1.0f);
    vec3 n = dot(normal, vec3(0.1f, -0.5f, 1.0f)) < 0.0f ? -normal : normal;  // One side of it draws.
    vec3 right = normalize(cross(up, n));
    vec2 direction = hatching_direction(hatching);
    return -direction.y * right + direction.x * cross(n, right);
}

// The coordinate along `across` (eye coordinates), from local_center, where the plane is seen at a place of the picture
// plane. `normal`, `offset`: of the plane, eye coordinates.
float hatching_coordinate(vec2 at, vec3 normal, float offset, vec3 across) {
    vec3 p;
    if (view.depth_range.z > 0.5f)
        p = vec3(at, (offset - dot(vec2(normal), at)) / normal.z);
    else
        p = vec3(at, -1.0f) * (offset / dot(normal, vec3(at, -1.0f)));
    return dot(across, p - center_in_eye);
}

// Coverage of the pixel by lines of hatching on a surface that lies in `plane`; 0 on those that no section made.
float section_lines(uint leaf, uint plane, ivec2 pixel) {
    if (!is_section(leaf))
        return 0.0f;
    mat3 turn = mat3(view.eye_from_world);
    vec4 row = plane_rows[plane];
    vec3 normal = turn * vec3(row);
    float offset = row.w + dot(normal, center_in_eye);
    vec3 across = turn * across_hatching(vec3(row), leaf_rows[leaf].part.z);
    float here = hatching_coordinate(picture_position(pixel), normal, offset, across);
    float right = hatching_coordinate(picture_position(pixel + ivec2(1, 0)), normal, offset, across);
    float above = hatching_coordinate(picture_position(pixel + ivec2(0, 1)), normal, offset, across);
    float lines_a_pixel = length(vec2(right - here, above - here)) / section_spacing;
    float apart = abs(fract(here / section_spacing) - 0.5f) / max(lines_a_pixel, 1e-6f);
    float line = clamp(0.5f * kHatchingWidth + 0.5f - apart, 0.0f, 1.0f);
    // Lines that the picture cannot tell apart are a tone.
    return mix(line, min(kHatchingWidth * lines_a_pixel, 0.5f), smoothstep(0.2f, 0.4f, lines_a_pixel));
}

// A color with these lines over it: darker than it, or lighter than a dark one.
vec4 hatched(vec4 c, uint leaf, uint plane, ivec2 pixel) {
    float lines = section_lines(leaf, plane, pixel);
    float brightness = dot(vec3(c), vec3(0.2126f, 0.7152f, 0.0722f));
    vec3 ink = brightness > 0.3f ? 0.35f * vec3(c) : mix(vec3(c), vec3(1.0f), 0.55f);
    return vec4(mix(vec3(c), ink, lines), c.a);
}
