// One surface of a stack of layers. Valid in shaders and, within a struct with the same names, in C++.

const uint kNoSurface = 0xffffffffu;  // in place of a leaf: the pixel has no more layers

// csg::PartKind
const uint kPartSolid = 0u;
const uint kPartTranslucent = 1u;
const uint kPartBackground = 2u;
const uint kPartHighlight = 3u;

struct Surface {
    bool hit;        // false: no surface here; nothing else is meaningful
    float depth;     // reversed, see gl/view.glsl
    vec3 normal;     // outward normal of the result, world coordinates
    uint leaf;
    uint plane;
    uint part;
    uint part_kind;
    bool reversed;   // of a subtracted leaf: a cut
    bool leaving;    // a back face of the result
    vec4 color;      // as given by color(); r < 0 where there is none
};

Surface no_surface() {
    Surface s;
    s.hit = false;
    s.depth = 0.0f;
    return s;
}

// `ids`, `depth`: as the stack holds them. `ray`: world direction of the pixel's ray (any length); it decides on which
// side of its plane the surface is.
Surface surface_of(uvec2 ids, float depth, vec3 ray) {
    Surface s;
    s.hit = true;
    s.depth = depth;
    s.leaf = ids.x >> 1;
    s.reversed = (ids.x & 1u) != 0u;
    s.plane = ids.y >> 1;
    s.leaving = (ids.y & 1u) != 0u;
    s.part = leaf_rows[s.leaf].part.x;
    s.part_kind = leaf_rows[s.leaf].part.y;
    s.color = leaf_rows[s.leaf].color;
    vec3 n = vec3(plane_rows[s.plane]);
    // The outward normal faces the eye where the ray enters, and turns away where it leaves.
    s.normal = (dot(n, ray) > 0.0f) == s.leaving ? n : -n;
    return s;
}
