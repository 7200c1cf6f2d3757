// Outlines by the indices of their points.
#pragma once

#include "csg/solid/grid_point.h"
#include "csg/solid/outline.h"

namespace csg::solid {

/// Corners in the same place are one point. Loops by indices; points are in the order of their first corners.
struct IndexedOutline {
    std::vector<glm::dvec2> points;
    std::vector<std::vector<std::uint32_t>> loops;
};

[[nodiscard]] IndexedOutline index_corners(const Outline& outline);

/// The points in whole numbers: 2^-58 of the largest coordinate, so that none that matters is rounded.
[[nodiscard]] std::vector<GridPoint> exact_points(std::span<const glm::dvec2> points);

/// The edges of the loops, sorted, each once, with the region that lies to the left of each, to the last bit; empty
/// where the loops are not in the form of Outline as far as single edges tell: one of no length, or used twice.
struct LoopEdges {
    std::vector<GridEdge> edges;
    std::vector<std::uint32_t> from, to;  ///< Points at the lesser and the greater end.
};
[[nodiscard]] LoopEdges edges_of(std::span<const GridPoint> points, std::span<const std::vector<std::uint32_t>> loops);

/// Does the outline keep the rule of Outline, checked exactly in the doubles that it has?
[[nodiscard]] bool is_region(const Outline& outline);

}  // namespace csg::solid
