// Triangles that stand for smooth surfaces, by plane: what shading that does not show facets is told by.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace layers {

/// A triangle, in the layout of the storage block of npr/frame.glsl, under the same names.
struct SmoothFacet {
    glm::vec4 first{0};   ///< How much of the first corner there is at a point p: dot(xyz, p) + w; 1 there, 0 opposite.
    glm::vec4 second{0};  ///< The same of the second one; the third has what is left of 1.
    glm::uvec4 normals{0};  ///< At the corners, packed (npr/smooth_normal.glsl); the triangle's leaf.
};

struct SmoothFacets {
    /// By plane: the first of its facets, which are sorted by leaf; and an end. Empty: not known, as long as nobody
    /// shades smoothly.
    std::vector<std::uint32_t> starts;
    std::vector<SmoothFacet> facets;
};

}  // namespace layers
