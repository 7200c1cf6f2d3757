// Projects the triangles of all leaves, once a view.
#include "gl/view.glsl"
#include "goldfeather/triangles.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 2) readonly buffer Vertices { float vertices[]; };  // three floats each, local coordinates
layout(std430, binding = 3) readonly buffer TriangleIds { uvec2 triangle_ids[]; };  // plane, leaf
layout(std430, binding = 4) readonly buffer PlaneDepths { vec4 plane_depths[]; };
layout(std430, binding = 5) writeonly buffer Positions { vec4 positions[]; };
layout(std430, binding = 6) writeonly buffer Triangles { TriangleRow triangles[]; };

uniform uint first_triangle;
uniform uint triangle_count;  // of all

void main() {
    uint triangle = first_triangle + gl_GlobalInvocationID.x;
    if (triangle >= triangle_count)
        return;
    float nearest = 0.0, farthest = 1.0;
    for (uint v = 3u * triangle; v < 3u * triangle + 3u; ++v) {
        vec4 p = view.clip_from_local * vec4(vertices[3u * v], vertices[3u * v + 1u], vertices[3u * v + 2u], 1.0);
        positions[v] = p;
        // A vertex in front of the near plane is clipped: the triangle reaches up to it.
        float depth = p.z < p.w ? p.z / p.w : 1.0;
        // Sums of four products of rounded factors. Limits narrower than their error would cut coplanar triangles
        // differently.
        vec4 terms = abs(view.clip_from_local[0] * vertices[3u * v]) + abs(view.clip_from_local[1] * vertices[3u * v + 1u]) +
                     abs(view.clip_from_local[2] * vertices[3u * v + 2u]) + abs(view.clip_from_local[3]);
        float error = p.z < p.w ? 5e-7 * (terms.z + depth * terms.w) / p.w : 0.0;
        nearest = max(nearest, depth + error);
        farthest = min(farthest, depth - error);
    }
    uvec2 ids = triangle_ids[triangle];
    triangles[triangle] = TriangleRow(plane_depths[ids.x], vec2(farthest, nearest), ids.x, ids.y);
}
