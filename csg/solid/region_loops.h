// The boundary of a region as loops.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "csg/solid/grid_point.h"

namespace csg::solid {

using GridLoop = std::vector<GridPoint>;

/// What is inside, by how often it is wound around: by the weights of edges and by their other weights.
using Inside = std::function<bool(int, int)>;

/// The boundary, by the rule of Outline, of where `inside` holds among arranged edges (arrangement.h). Points where a
/// loop goes straight on and no other passes are left out. Loops begin at their least point and are in ascending order
/// of it. Throws OutlineError where the edges conflict.
[[nodiscard]] std::vector<GridLoop> boundary(std::span<const GridEdge> arranged, const Inside& inside);

}  // namespace csg::solid
