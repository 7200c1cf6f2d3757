// The faces of a mesh as convex polygons.
#pragma once

#include <vector>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// Convex polygons that cover the mesh's triangles, few and large: of neighboring triangles in one plane, the edge
/// between them is removed where the polygons on its two sides are convex together, long edges first (Hertel and
/// Mehlhorn 1983: at most four times as many as there have to be). Each in turn, counter-clockwise seen from outside.
[[nodiscard]] std::vector<std::vector<glm::dvec3>> convex_facets(const Mesh& mesh);

}  // namespace csg::reference
