// One surface of a stack of layers.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace layers {

/// What shaders and C++ agree on: layers/surface_ids.glsl and layers/part_kinds.glsl.
struct SurfaceCode {
    using uint = std::uint32_t;
    using uvec2 = glm::uvec2;
#include "layers/part_kinds.glsl"
#include "layers/surface_ids.glsl"
};

/// "No surface" in place of a leaf's word.
inline constexpr std::uint32_t kNoSurface = SurfaceCode().kNoSurface;

struct Surface {
    float depth = 0;  ///< Reversed depth (base::View); 0: there is no surface.
    std::uint32_t leaf = 0;
    std::uint32_t plane = 0;
    bool reversed = false;  ///< Of a subtracted leaf.
    bool leaving = false;   ///< The ray leaves the result there: a back face of it.
    bool operator==(const Surface&) const = default;
};

/// A surface's two words in a stack.
[[nodiscard]] inline glm::uvec2 encode(const Surface& s) {
    SurfaceCode code;
    return {code.leaf_word(s.leaf, s.reversed), code.plane_word(s.plane, s.leaving)};
}

/// The surface that a stack holds as these words, at that depth.
[[nodiscard]] inline Surface decode(float depth, const glm::uvec2& ids) {
    SurfaceCode code;
    return ids.x == kNoSurface
               ? Surface{}
               : Surface{depth, code.leaf_of(ids), code.plane_of(ids), code.is_reversed(ids), code.is_leaving(ids)};
}

}  // namespace layers
