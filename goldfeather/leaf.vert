// Draws leaves: three prepared vertices a triangle; per draw (base instance) the leaf's id and slot.
#include "goldfeather/triangles.glsl"

layout(location = 0) in uvec2 leaf_and_slot;
layout(location = 1) in vec4 position;

layout(std430, binding = 8) readonly buffer Triangles { TriangleRow triangles[]; };

flat out vec4 plane_depth;
flat out vec2 depth_limits;
flat out uint slot;
flat out uint plane;

void main() {
    gl_Position = position;
    TriangleRow row = triangles[gl_VertexID / 3];
    plane_depth = row.plane_depth;
    depth_limits = row.depth_limits;
    plane = row.plane;
    slot = leaf_and_slot.y;
}
