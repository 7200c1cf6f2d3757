// Solids whose faces lie across one axis or along it, as prisms on top of each other.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "csg/solid/node_geometry.h"

namespace csg::solid {

/// What is over a region between two heights along z.
struct Prism {
    double lo = 0, hi = 0;
    std::shared_ptr<const Outline> outline;
};

/// From below upwards; none overlaps another, and those that touch have different outlines.
using PrismStack = std::vector<Prism>;

/// The union of the pieces, computed in the plane alone. Nothing where a face of one of them is neither along z nor
/// across it (up to 2^-40 of the largest coordinate), a mesh is not closed, or the heights are many. Throws
/// OutlineError.
[[nodiscard]] std::optional<PrismStack> prisms_of(std::span<const Piece> pieces);

/// The Minkowski sum: of each prism with each, a sum of outlines and of heights. Throws OutlineError.
[[nodiscard]] PrismStack minkowski(const PrismStack& a, const PrismStack& b);

/// Each prism as a mesh that is closed; two that touch do so exactly.
[[nodiscard]] std::vector<Mesh> meshes_of(const PrismStack& stack);

/// The Minkowski sum of operands (each the union of its pieces) all of whose faces lie along x, y or z or across it, as
/// meshes whose union it is: sums of prisms need no arrangement in space. Nothing where they are not such, or all are
/// convex. Throws OutlineError.
[[nodiscard]] std::optional<std::vector<Mesh>> minkowski_of_prisms(std::span<const std::vector<Piece>> operands);

}  // namespace csg::solid
