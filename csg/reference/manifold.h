// Points of a surface told apart where sheets of it only touch.
#pragma once

#include <span>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// `mesh` is the boundary of a solid in which several sheets may share an edge or a point. Afterwards triangles share
/// a point only where they are neighbours around it, and at every edge those two triangles are neighbours that have
/// the solid between them. `normals`: outward, by triangle. Unused points are dropped.
void separate_sheets(Mesh& mesh, std::span<const glm::dvec3> normals);

}  // namespace csg::reference
