// The one vertex arithmetic and the one depth of all geometry passes: equal triangles give equal pixels, and faces on
// one canonical plane give bit-equal depth from every leaf.
#include "gl/view.glsl"

layout(binding = 8) uniform samplerBuffer leaf_vertices;
layout(binding = 9) uniform usamplerBuffer triangle_planes;
layout(std430, binding = 8) readonly buffer PlaneDepths { vec4 plane_depths[]; };

vec4 leaf_position(int vertex) {
    return view.clip_from_local * vec4(texelFetch(leaf_vertices, vertex).xyz, 1.0);
}
