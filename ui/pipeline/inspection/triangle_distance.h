// How near two triangles come to each other.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace ui {

using Corners = std::array<glm::dvec3, 3>;

struct Nearest {
    double distance = 0;
    glm::dvec3 a{0.0}, b{0.0};  ///< The points, one of each.
};

/// 0 where they meet. By the ends and edges that the shortest line between two triangles has (Ericson, Real-Time
/// Collision Detection, 2005, section 5.1).
[[nodiscard]] Nearest nearest_points(const Corners& a, const Corners& b);

}  // namespace ui
