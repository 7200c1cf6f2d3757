// Minkowski sums.
#pragma once

#include <span>
#include <stop_token>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The Minkowski sum of closed meshes, one after the other: the union of the hulls of the sums of convex pieces. A
/// piece of a mesh that is convex but for rounding (a tessellated sphere is) is taken as its hull; others are
/// decomposed in exact arithmetic (nef.h). All sources are 0. Throws std::runtime_error where a mesh is not closed.
[[nodiscard]] Mesh minkowski_sum(std::span<const Mesh> operands, const std::stop_token& stop = {});

}  // namespace csg::reference
