// Resolves lists of any length.
#include "goldfeather/lists/lists.glsl"
#include "goldfeather/triangles.glsl"
#include "goldfeather/lists/blist.glsl"

layout(std430, binding = 8) readonly buffer Triangles { TriangleRow triangles[]; };

uniform bool count_inside;  // the eye is among the leaves: inside is counted from behind

const bool kPauses = true;

#include "goldfeather/lists/list_long.glsl"
#include "goldfeather/lists/resolve_lists.glsl"
