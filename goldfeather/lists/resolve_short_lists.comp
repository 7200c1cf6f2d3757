// Resolves lists of at most kCapacity surfaces.
#include "goldfeather/lists/lists.glsl"
#include "goldfeather/triangles.glsl"
#include "goldfeather/lists/blist.glsl"

layout(std430, binding = 8) readonly buffer Triangles { TriangleRow triangles[]; };

uniform bool count_inside;  // the eye is among the leaves: inside is counted from behind

// The shortest lists have no room for a state, and need none.
const bool kPauses = kCapacity > 8;

#include "goldfeather/lists/list_short.glsl"
#include "goldfeather/lists/resolve_lists.glsl"
