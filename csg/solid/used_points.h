// Meshes without the points that no triangle has.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

namespace csg::solid {

/// The points that the triangles have, in the order in which they are first met; the triangles have their numbers then.
[[nodiscard]] inline std::vector<glm::dvec3> used_points(std::span<const glm::dvec3> points,
                                                         std::span<glm::uvec3> triangles) {
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(points.size(), kNone);
    std::vector<glm::dvec3> used;
    for (glm::uvec3& t : triangles) {
        for (int k = 0; k < 3; ++k) {
            std::uint32_t& n = number[t[k]];
            if (n == kNone) {
                n = static_cast<std::uint32_t>(used.size());
                used.push_back(points[t[k]]);
            }
            t[k] = n;
        }
    }
    return used;
}

}  // namespace csg::solid
