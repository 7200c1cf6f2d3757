// A plain draw: one matrix, one normal.
#include "gl/view.glsl"

layout(location = 0) in vec3 position;  // local coordinates
layout(location = 1) in vec3 normal;

flat out vec3 eye_normal;

void main() {
    gl_Position = view.clip_from_local * vec4(position, 1.0);
    eye_normal = mat3(view.eye_from_world) * normal;
}
