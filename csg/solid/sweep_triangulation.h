// Triangulation of regions in one sweep.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "csg/solid/grid_point.h"

namespace csg::solid {

/// Triangles that fill the region whose loops, by indices into `points`, keep the rule of Outline but may touch
/// themselves; counter-clockwise, none of negative area. Every directed edge of a loop is an edge of exactly one
/// triangle, every other edge of two, in opposite directions. Nothing where the loops are of another kind. By Hertel
/// and Mehlhorn (1983), in time O(n log n).
[[nodiscard]] std::optional<std::vector<glm::uvec3>> triangulate_by_sweep(
    std::span<const GridPoint> points, std::span<const std::vector<std::uint32_t>> loops);

}  // namespace csg::solid
