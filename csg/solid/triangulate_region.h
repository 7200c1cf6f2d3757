// Triangulation of regions with holes.
#pragma once

#include <vector>

#include "csg/solid/outline.h"

namespace csg::solid {

/// Triangles that fill `outline`, counter-clockwise; a corner is the position of its point when the loops are put one
/// after the other. Every directed edge of a loop is an edge of exactly one triangle and every other edge of two, in
/// opposite directions, whatever the loops look like; so caps and walls that share vertices close.
[[nodiscard]] std::vector<glm::uvec3> triangulate_region(const Outline& outline);

}  // namespace csg::solid
