// Fewer and larger convex sets within a solid.
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "csg/reference/convex.h"

namespace csg::reference {

/// Convex sets within a solid that hold all of `pieces` (polygons or polyhedra within it): neighbors, which share two
/// points, are replaced by their hull where that lies in the solid: where none of `facets`, which cover the solid's
/// surface, cuts it by more than the tolerance, and `holds` says so of its middle. Which are tried first is a matter of
/// their order: the result is small, not smallest. Throws base::Stopped where `stop` asked for it.
[[nodiscard]] std::vector<Convex> grown(std::vector<Convex> pieces, std::span<const std::vector<glm::dvec3>> facets,
                                        double tolerance, const std::function<bool(const glm::dvec3&)>& holds,
                                        const std::stop_token& stop = {});

}  // namespace csg::reference
