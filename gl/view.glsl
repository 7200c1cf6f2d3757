// What every pass knows of the view; filled by gl/view_block.h.
layout(std140, binding = 0) uniform ViewBlock {
    mat4 clip_from_local;   // local: world minus a center, so that floats are small
    mat4 eye_from_world;    // rotation only is meant for directions
    vec4 picture;           // width, height, half height of the picture at distance 1 (or in world units), near
    vec4 depth_range;       // near, far (0: infinite), orthographic (1) or perspective (0), scene diagonal
    vec4 local_center;      // world = local + local_center
} view;

#include "gl/view_distance.glsl"

// Eye coordinates of the point at `depth` in the pixel of `frag_coord`.
vec3 view_position(vec2 frag_coord, float depth) {
    float t = view_distance(depth);
    vec2 at = (frag_coord - 0.5 * view.picture.xy) * (2.0 * view.picture.z / view.picture.y);
    return vec3(view.depth_range.z > 0.5 ? at : at * t, -t);
}
