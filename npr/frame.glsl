#include "gl/view.glsl"
#include "layers/layer_stack.glsl"

// What every pass of a style knows: the uniforms of npr/frame_values.h, whose table declares them.
#include "npr/frame_values.glsl"

// The media of parts (npr/medium_rows.h).
struct MediumRow {
    ivec4 high;
    ivec4 low;
    ivec4 is_medium;
};
layout(std430, binding = 11) readonly buffer MediumRows { MediumRow medium_rows[]; };

// Facets of smooth surfaces (layers/smooth_facets.h).
struct SmoothFacet {
    vec4 first;
    vec4 second;
    uvec4 normals;
};
layout(std430, binding = 12) readonly buffer FacetStarts { uint facet_starts[]; };
layout(std430, binding = 13) readonly buffer SmoothFacets { SmoothFacet smooth_facets[]; };

#include "npr/table_rows.glsl"

vec4 eye_plane(uint plane) {
    return plane_in_eye(plane);
}

CornerNormals corner_normals(uint facet) {
    return normals_of_corners(facet);
}

uint facet_start(uint plane) {
    return facet_starts[plane];
}

ivec2 picture_size() {
    return textureSize(layer_depths, 0).xy;
}

bool in_picture(ivec2 pixel) {
    return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, picture_size()));
}

// Leaf and plane as the stack holds them; kNoSurface where the pixel, which must be in the picture, has no such layer.
uvec2 surface_ids(ivec2 pixel, int layer) {
    return layer < layer_count ? texelFetch(layer_surfaces, ivec3(pixel, layer), 0).xy : uvec2(kNoSurface);
}

// Reversed; 0 where the pixel, which must be in the picture, has no such layer.
float layer_depth(ivec2 pixel, int layer) {
    return layer < layer_count ? texelFetch(layer_depths, ivec3(pixel, layer), 0).x : 0.0;
}

// Of view-dependent pictures (npr/shine/shine.h).
#include "npr/shine/shine_row.glsl"
layout(std430, binding = 16) readonly buffer ShineRows { ShineRow shine_rows[]; };

ShineRow shine_row(ivec2 pixel) {
    return shine_rows[pixel.y * picture_size().x + pixel.x];
}

// npr/cast_shadows.h
layout(std430, binding = 14) readonly buffer ShadowRows { uint shadow_rows[]; };

uint shadow_bits(ivec2 pixel) {
    return shadow_rows[pixel.y * picture_size().x + pixel.x];
}

#include "npr/pixel.glsl"
