#include "gl/view.glsl"
#include "peel/layer_stack.glsl"

// What every pass of a style knows (npr/frame_program.h). Colors are sRGB with straight alpha.
uniform int layer_count;
uniform vec3 centre_in_eye;  // eye coordinates of the origin of plane_rows
uniform vec2 jitter;  // of the sample from the pixel's centre, in pixels
uniform vec3 background_color;
uniform vec3 background_stop;
uniform vec3 face_color;
uniform vec3 cut_color;
uniform vec4 highlight_color;
uniform vec4 ghost_color;
uniform bool transparent_background;

// Coordinates of the pixel's sample in the picture plane: at distance 1 (perspective), in world units (orthographic).
vec2 picture_position(ivec2 pixel) {
    return (vec2(pixel) + 0.5 + jitter - 0.5 * view.picture.xy) * (2.0 * view.picture.z / view.picture.y);
}

// World direction of the ray through the pixel's sample.
vec3 pixel_ray(ivec2 pixel) {
    vec3 in_eye = vec3(view.depth_range.z > 0.5 ? vec2(0.0) : picture_position(pixel), -1.0);
    return in_eye * mat3(view.eye_from_world);
}

vec3 background(ivec2 pixel) {
    return mix(background_stop, background_color, (float(pixel.y) + 0.5 + jitter.y) / view.picture.y);
}

// Are they of the same part, and of the same color?
bool look_alike(uint leaf, uint other) {
    return leaf == other ||
           (leaf_rows[leaf].part.x == leaf_rows[other].part.x && leaf_rows[leaf].color == leaf_rows[other].color);
}
