// One surface of a stack of layers. Valid in shaders and, within a struct with the same names, in C++.

#include "layers/part_kinds.glsl"
#include "layers/surface_ids.glsl"

struct Surface {
    bool hit;        // false: no surface here; nothing else is meaningful, though it may be read
    float depth;     // reversed, see gl/view.glsl
    vec3 normal;     // outward normal of the result, world coordinates
    uint leaf;
    uint plane;
    uint part;
    uint part_kind;
    bool reversed;   // of a subtracted leaf: a cut
    bool leaving;    // a back face of the result
    bool covered;    // not seen, whatever is before it: see npr/transparency.glsl
    float ink;       // of a silhouette that lies on it, 0 to 1: see npr/transparency.glsl
    vec4 color;      // as given by color(), with its part's opacity; below 0 what is not
};

Surface no_surface() {
    Surface s;
    s.hit = false;
    s.depth = 0.0f;
    s.normal = vec3(0.0f);
    s.leaf = 0u;
    s.plane = 0u;
    s.part = 0u;
    s.part_kind = kPartSolid;
    s.reversed = false;
    s.leaving = false;
    s.covered = false;
    s.ink = 0.0f;
    s.color = vec4(0.0f);
    return s;
}

// `ids`, `depth`: as the stack holds them. `ray`: world direction of the pixel's ray (any length); it decides on which
// side of its plane the surface is.
Surface surface_of(uvec2 ids, float depth, vec3 ray) {
    Surface s;
    s.hit = true;
    s.depth = depth;
    s.leaf = leaf_of(ids);
    s.reversed = is_reversed(ids);
    s.plane = plane_of(ids);
    s.leaving = is_leaving(ids);
    s.covered = false;
    s.ink = 0.0f;
    s.part = leaf_rows[s.leaf].part.x;
    s.part_kind = leaf_rows[s.leaf].part.y;
    s.color = leaf_rows[s.leaf].color;
    vec3 n = vec3(plane_rows[s.plane]);
    // The outward normal faces the eye where the ray enters, and turns away where it leaves.
    s.normal = (dot(n, ray) > 0.0f) == s.leaving ? n : -n;
    return s;
}
