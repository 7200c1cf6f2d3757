// Pieces of a mesh that are nothing but rounding.
#pragma once

#include "csg/reference/mesh.h"

namespace csg::reference {

/// Drops the connected pieces of a closed mesh, solid or hollow ones, that are flat and no thicker than a few roundings
/// of their coordinates: where faces are flush but for rounding, exact arithmetic leaves such flakes.
void drop_thin_pieces(Mesh& mesh);

}  // namespace csg::reference
