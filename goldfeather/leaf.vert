// Draws leaves: three vertices a triangle, pulled from a buffer; per draw (base instance) the leaf's id and slot.
#include "goldfeather/leaf.glsl"

layout(location = 0) in uvec2 leaf_and_slot;

flat out vec4 plane_depth;   // see View::PlaneDepth; w: edge-on
flat out vec2 depth_limits;  // of the triangle's vertices
flat out uint leaf;
flat out uint slot;
flat out uint plane;

void main() {
    int triangle = gl_VertexID / 3;
    float nearest = 0.0, farthest = 1.0;
    vec4 own;
    for (int i = 0; i < 3; ++i) {
        vec4 p = leaf_position(3 * triangle + i);
        if (3 * triangle + i == gl_VertexID)
            own = p;
        // A vertex in front of the near plane is clipped: the triangle reaches up to it.
        float depth = p.z < p.w ? p.z / p.w : 1.0;
        nearest = max(nearest, depth);
        farthest = min(farthest, depth);
    }
    gl_Position = own;
    plane = texelFetch(triangle_planes, triangle).x;
    plane_depth = plane_depths[plane];
    depth_limits = vec2(farthest, nearest);
    leaf = leaf_and_slot.x;
    slot = leaf_and_slot.y;
}
