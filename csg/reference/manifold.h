// Points of a surface told apart where sheets of it only touch.
#pragma once

#include <span>
#include <vector>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// `mesh` is the boundary of a solid in which several sheets may share an edge or a point. Afterwards triangles share
/// a point only where they are neighbors around it, and at every edge those two triangles are neighbors that have
/// the solid between them. An edge at which two sheets touch that are connected around both of its ends gets a point in
/// its middle. `normals`: outward, by triangle. Unused points are dropped. A mesh that is no such
/// boundary is left not manifold (`facts` tells).
void separate_sheets(Mesh& mesh, std::span<const glm::dvec3> normals);

/// The same where it is known how triangles lie around the edges that more than two share: `turns`, by corner (3 t + k
/// for corner k of triangle t), is larger the farther counter-clockwise, seen against the edge's lo → hi (by number of
/// point), the triangle lies; for the edge from that corner to the next. May be empty where there is no such edge.
void separate_sheets(Mesh& mesh, std::vector<double> turns);

}  // namespace csg::reference
