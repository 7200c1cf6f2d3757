// How often a closed mesh winds around a point.
#pragma once

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The winding number of a closed, evenly oriented mesh about a point that is not on it: the solid angles of its
/// triangles (van Oosterom and Strackee 1983), rounded.
[[nodiscard]] long winding_number(const Mesh& mesh, const glm::dvec3& point);

}  // namespace csg::reference
