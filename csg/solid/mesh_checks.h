// What a mesh given by hand is: closed, convex.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "csg/solid/solid.h"

namespace csg::solid {

/// For each point the smallest index of a point with the same coordinates.
[[nodiscard]] std::vector<std::uint32_t> first_of_equals(std::span<const glm::dvec3> points);

/// The same for points no farther apart than `distance` along each axis, chains of such points counting as one.
[[nodiscard]] std::vector<std::uint32_t> first_of_near(std::span<const glm::dvec3> points, double distance);

/// Puts the first of equals for each index of the loop `face`; of neighbors that become one, one is left.
void weld(std::vector<std::uint32_t>& face, std::span<const std::uint32_t> first);

/// Sets `closed`, `convex` and `simple`. A mesh too big to be tested for convexity counts as not convex.
void check_mesh(Solid& solid);

}  // namespace csg::solid
