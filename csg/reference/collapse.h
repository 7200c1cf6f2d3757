// Edges without length.
#pragma once

#include "csg/reference/mesh.h"

namespace csg::reference {

/// Makes one of the two ends of an edge whose ends lie at one place, wherever a closed, manifold mesh stays one; the
/// triangles at the edge go. Unused points are dropped.
void collapse_empty_edges(Mesh& mesh);

}  // namespace csg::reference
