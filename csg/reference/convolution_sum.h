// Minkowski sums with a convex polyhedron by their convolution.
#pragma once

#include <optional>
#include <span>
#include <stop_token>

#include "csg/reference/convex.h"

namespace csg::reference {

/// The sum of the union of `meshes`, closed and evenly oriented, and `b`, whose work is that of the result and what
/// crosses in it: the patches of convolution.h, and of their pieces those before which the sum does not go on
/// (patch_surface.h). A point x is in it exactly where x - b meets a mesh's surface or is inside. All sources are 0.
/// Nothing where a mesh crosses itself or touches itself along an edge, or something is within the tolerance of being
/// degenerate. Throws base::Stopped where `stop` asked for it.
[[nodiscard]] std::optional<Mesh> convolution_sum(std::span<const Mesh> meshes, const Convex& b,
                                                  const std::stop_token& stop = {});

}  // namespace csg::reference
