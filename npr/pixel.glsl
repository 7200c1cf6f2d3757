// Pixels and surfaces of a frame. Valid in shaders and, within a struct with the same names, in C++.

// Coordinates of the pixel's sample in the picture plane: at distance 1 (perspective), in world units (orthographic).
vec2 picture_position(ivec2 pixel) {
    return (vec2(pixel) + 0.5f + jitter - 0.5f * vec2(view.picture)) * (2.0f * view.picture.z / view.picture.y);
}

// World direction of the ray through the pixel's sample.
vec3 pixel_ray(ivec2 pixel) {
    vec3 in_eye = vec3(view.depth_range.z > 0.5f ? vec2(0.0f) : picture_position(pixel), -1.0f);
    return in_eye * mat3(view.eye_from_world);
}

vec3 background(ivec2 pixel) {
    return mix(background_stop, background_color, (float(pixel.y - guard) + 0.5f + jitter.y) / (view.picture.y - 2.0f * float(guard)));
}

// Are they of the same part, and of the same color?
bool look_alike(uint leaf, uint other) {
    return leaf == other ||
           (leaf_rows[leaf].part.x == leaf_rows[other].part.x && leaf_rows[leaf].color == leaf_rows[other].color);
}

// Is it drawn as a body of which only what is within is seen?
bool is_medium(uint part) {
    return medium_rows[part].is_medium.x != 0;
}

// Hides everything behind it.
bool opaque(uvec2 ids) {
    uvec4 part = leaf_rows[leaf_of(ids)].part;
    return part.y == kPartSolid && !is_medium(part.x);
}
