// What of a polygon lies behind planes.
#pragma once

#include <span>
#include <vector>

#include "csg/solid/plane_table.h"

namespace csg::reference {

/// Is something of the convex polygon deeper behind all planes than `depth`? Sutherland and Hodgman 1974.
[[nodiscard]] bool cuts(std::vector<glm::dvec3> polygon, std::span<const solid::Plane> planes, double depth);

}  // namespace csg::reference
