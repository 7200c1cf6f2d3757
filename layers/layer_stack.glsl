// Reads a bound stack of layers (layers/texture_stack.h).

layout(binding = 0) uniform sampler2DArray layer_depths;
layout(binding = 1) uniform usampler2DArray layer_surfaces;

struct LeafRow {
    vec4 color;
    uvec4 part;
};
layout(std430, binding = 0) readonly buffer LeafRows { LeafRow leaf_rows[]; };
layout(std430, binding = 1) readonly buffer PlaneRows { vec4 plane_rows[]; };

#include "layers/surface.glsl"

// `pixel` outside the picture gives no surface. `ray`: see surface_of.
Surface layer_surface(ivec2 pixel, int layer, vec3 ray) {
    ivec3 size = textureSize(layer_depths, 0);
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size.xy)) || layer >= size.z)
        return no_surface();
    uvec2 ids = texelFetch(layer_surfaces, ivec3(pixel, layer), 0).xy;
    if (ids.x == kNoSurface)
        return no_surface();
    return surface_of(ids, texelFetch(layer_depths, ivec3(pixel, layer), 0).x, ray);
}
