// How often a mesh winds around a point.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace csg::solid {

/// The winding number of a closed, evenly oriented mesh about a point that is not on it: the sum of the solid angles of
/// its triangles (van Oosterom and Strackee 1983), rounded.
[[nodiscard]] long winding_number(std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles,
                                  const glm::dvec3& point);

}  // namespace csg::solid
