// Reads a bound stack of layers (peel/layer_stack.h).

layout(binding = 0) uniform sampler2DArray layer_depths;
layout(binding = 1) uniform usampler2DArray layer_surfaces;

const uint kNoSurface = 0xffffffffu;  // in layer_surfaces' red: the pixel has no more layers

struct LeafRow {
    vec4 color;
    uvec4 part;
};
layout(std430, binding = 0) readonly buffer LeafRows { LeafRow leaf_rows[]; };
layout(std430, binding = 1) readonly buffer PlaneRows { vec4 plane_rows[]; };

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

// `pixel` outside the picture gives no surface. `ray` is the world direction of the pixel's ray (any length): it
// decides on which side of its plane the surface is.
Surface layer_surface(ivec2 pixel, int layer, vec3 ray) {
    Surface s;
    s.hit = false;
    s.depth = 0.0;
    ivec3 size = textureSize(layer_depths, 0);
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size.xy)) || layer >= size.z)
        return s;
    uvec2 ids = texelFetch(layer_surfaces, ivec3(pixel, layer), 0).xy;
    if (ids.x == kNoSurface)
        return s;
    s.hit = true;
    s.depth = texelFetch(layer_depths, ivec3(pixel, layer), 0).x;
    s.leaf = ids.x >> 1;
    s.reversed = (ids.x & 1u) != 0u;
    s.plane = ids.y >> 1;
    s.leaving = (ids.y & 1u) != 0u;
    s.part = leaf_rows[s.leaf].part.x;
    s.part_kind = leaf_rows[s.leaf].part.y;
    s.color = leaf_rows[s.leaf].color;
    vec3 n = plane_rows[s.plane].xyz;
    // The outward normal faces the eye where the ray enters, and turns away where it leaves.
    s.normal = (dot(n, ray) > 0.0) == s.leaving ? n : -n;
    return s;
}
