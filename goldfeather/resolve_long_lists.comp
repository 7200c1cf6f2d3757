// Resolves lists of any length.
#include "goldfeather/lists.glsl"
#include "goldfeather/triangles.glsl"
#include "goldfeather/blist.glsl"

layout(std430, binding = 8) readonly buffer Triangles { TriangleRow triangles[]; };

uniform bool count_inside;  // the eye is among the leaves: inside is counted from behind

const bool kPauses = true;

#include "goldfeather/list_long.glsl"
#include "goldfeather/resolve_lists.glsl"
