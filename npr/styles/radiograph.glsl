// How much of the ray lies within parts. Valid in shaders and, within a struct with the same names, in C++.

#include "npr/styles/radiograph_tones.glsl"

// `%` and `#` are not of the solid.
bool is_measured(uvec4 of_leaf) {
    return (of_leaf.y == kPartSolid || of_leaf.y == kPartTranslucent) && (part == 0 || of_leaf.x == uint(part - 1));
}

// In world units, within the part or, where parts overlap, in any of them. The ray begins at the eye (orthographic
// views: at the near plane), which may be inside.
float thickness(ivec2 pixel, vec3 ray) {
    int inside = 0;
    int layers = 0;
    while (layers < layer_count && surface_ids(pixel, layers).x != kNoSurface) {
        uvec2 ids = surface_ids(pixel, layers);
        if (is_measured(leaf_rows[leaf_of(ids)].part))
            inside += is_leaving(ids) ? 1 : -1;
        ++layers;
    }
    inside = max(inside, 0);
    float at = view.depth_range.z > 0.5f ? view.depth_range.x : 0.0f;
    float sum = 0.0f;
    for (int i = 0; i < layers; ++i) {
        uvec2 ids = surface_ids(pixel, i);
        if (!is_measured(leaf_rows[leaf_of(ids)].part))
            continue;
        float next = view_distance(layer_depth(pixel, i));
        if (inside > 0)
            sum += next - at;
        inside += is_leaving(ids) ? -1 : 1;
        at = next;
    }
    return sum * length(ray);
}

vec4 radiograph(ivec2 pixel) {
    float length_within = thickness(pixel, pixel_ray(pixel));
    if (colors == kValues)
        return vec4(vec3(length_within), 1.0f);
    float full = range > 0.0f ? range : 0.5f * view.depth_range.w;
    bool clear = transparent_background && length_within == 0.0f;
    return premultiplied(radiograph_tone(colors, clamp(length_within / full, 0.0f, 1.0f)), clear ? 0.0f : 1.0f);
}
