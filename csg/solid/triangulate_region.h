// Triangulation of regions with holes.
#pragma once

#include <vector>

#include "csg/solid/indexed_outline.h"

namespace csg::solid {

/// Triangles that fill `outline`, by the indices of its points, counter-clockwise. Every directed edge of a loop is an
/// edge of exactly one triangle and every other edge of two, in opposite directions, whatever the loops look like; so
/// caps and walls that share points close.
[[nodiscard]] std::vector<glm::uvec3> triangulate_region(const IndexedOutline& outline);

}  // namespace csg::solid
