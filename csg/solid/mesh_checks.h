// What a mesh given by hand is: closed, oriented, convex.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "csg/solid/solid.h"

namespace csg::solid {

/// For each point the smallest index of a point with the same coordinates.
[[nodiscard]] std::vector<std::uint32_t> first_of_equals(std::span<const glm::dvec3> points);

/// Sets `closed` and `convex` and adds warnings for a mesh that is open, non-manifold or inside out. A mesh too big
/// to be tested for convexity counts as not convex.
void check_mesh(Solid& solid);

}  // namespace csg::solid
