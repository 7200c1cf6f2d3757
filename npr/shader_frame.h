// The shared shader files in C++. What a style draws is written once, in files that are valid GLSL and, within a struct
// that has what they name, valid C++.
#pragma once

#include <vector>

#include "base/view_values.h"
#include "npr/edges/line_code.h"
#include "npr/frame_values.h"
#include "npr/medium_rows.h"
#include "npr/painter/cpu_frame.h"
#include "npr/painter/memo.h"
#include "npr/srgb.h"

namespace npr::shader {

using namespace glm;  // Shader files say vec3, dot and mix.

/// What npr/frame.glsl and the textures are to shaders, under the same names. Each thread has its own copy: members of
/// shader files are not const. Keeps references into the frame.
struct Frame : FrameValues, LineCode {
    using SmoothFacet = layers::SmoothFacet;

    explicit Frame(const CpuFrame& frame);

    base::ViewValues view;
    const layers::LeafRow* leaf_rows;
    const layers::PartLook* part_looks;
    const vec4* plane_rows;
    const uint* group_words;
    std::span<const uint> facet_starts;  ///< By plane, where facets are known.
    const layers::SmoothFacet* smooth_facets;
    ivec2 size;
    std::vector<const uvec2*> surfaces;  ///< By layer, then by pixel.
    std::vector<const float*> depths;
    const SrgbTables* srgb;
    std::vector<MediumRow> medium_rows;   ///< By part.
    std::span<const ShineRow> shine;      ///< By pixel.
    std::span<const ShadowBits> shadows;  ///< By pixel.

#include "gl/view_distance.glsl"
#include "layers/surface.glsl"
#include "npr/pixel.glsl"

#include "npr/table_rows.glsl"

    vec4 eye_plane(uint plane) {
        return eye_planes.of(plane, [&] { return plane_in_eye(plane); });
    }
    CornerNormals corner_normals(uint facet) {
        return corners.of(facet, [&] { return normals_of_corners(facet); });
    }

    [[nodiscard]] ivec2 picture_size() const {
        return size;
    }
    [[nodiscard]] bool in_picture(ivec2 p) const {
        return p.x >= 0 && p.y >= 0 && p.x < size.x && p.y < size.y;
    }
    [[nodiscard]] std::size_t index(ivec2 p) const {
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(p.x);
    }
    [[nodiscard]] float layer_depth(ivec2 p, int layer) const {
        return layer < layer_count ? depths[static_cast<std::size_t>(layer)][index(p)] : 0.0F;
    }
    [[nodiscard]] uvec2 surface_ids(ivec2 p, int layer) const {
        return layer < layer_count ? surfaces[static_cast<std::size_t>(layer)][index(p)] : uvec2(kNoSurface);
    }
    Surface layer_surface(ivec2 p, int layer, vec3 ray) {
        const uvec2 ids = in_picture(p) ? surface_ids(p, layer) : uvec2(kNoSurface);
        return ids.x == kNoSurface ? no_surface()
                                   : surface_of(ids, depths[static_cast<std::size_t>(layer)][index(p)], ray);
    }
    [[nodiscard]] uint facet_start(uint plane) const {
        return facet_starts.empty() ? 0 : facet_starts[plane];
    }
    [[nodiscard]] ShineRow shine_row(ivec2 p) const {
        return shine.empty() ? ShineRow{-1, 1 << 30, 1 << 30, 1, 0, 0} : shine[index(p)];
    }
    [[nodiscard]] uint shadow_bits(ivec2 p) const {
        return shadows[index(p)];
    }
    [[nodiscard]] vec4 premultiplied(vec3 color, float alpha) const {
        return {srgb->linear(color.r) * alpha, srgb->linear(color.g) * alpha, srgb->linear(color.b) * alpha, alpha};
    }

#include "npr/surface_color.glsl"

#include "npr/edges/line_ink.glsl"

    /// Does what is seen change from pixel to pixel, even where they see the same surfaces?
    [[nodiscard]] bool everywhere_new() const {
        return transparency == kViewDependent || transparency == kScreenDoor ||
               (transparency != kExact && medium_unit > 0);
    }
    /// Do two pixels see the same planes of the same leaves, in all layers?
    [[nodiscard]] bool same_surfaces(ivec2 p, ivec2 q) const;
    /// Is one of the planes that a pixel sees of a smooth surface?
    [[nodiscard]] bool sees_curves(ivec2 p) const;

  private:
    Memo<vec4, 10> eye_planes;        ///< By plane.
    Memo<CornerNormals, 10> corners;  ///< By facet.
};

}  // namespace npr::shader
