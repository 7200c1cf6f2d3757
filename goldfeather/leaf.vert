// Draws leaves: three prepared vertices a triangle. Where leaves have slots, per draw (base instance) the leaf's,
// and whether a ray that begins inside of it is counted from behind.
#include "goldfeather/triangles.glsl"

layout(location = 0) in uvec2 slot_and_behind;
layout(location = 1) in vec4 position;

layout(std430, binding = 8) readonly buffer Triangles { TriangleRow triangles[]; };

flat out vec4 plane_depth;
flat out vec2 depth_limits;
flat out uint slot;
flat out uint behind;
flat out uint plane;
flat out uint triangle;

void main() {
    gl_Position = position;
    triangle = uint(gl_VertexID) / 3u;
    TriangleRow row = triangles[triangle];
    plane_depth = row.plane_depth;
    depth_limits = row.depth_limits;
    plane = row.plane;
    slot = slot_and_behind.x;
    behind = slot_and_behind.y;
}
