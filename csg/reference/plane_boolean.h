// Booleans by an arrangement of canonical planes.
#pragma once

#include <stop_token>

#include "csg/reference/expression_value.h"
#include "csg/reference/leaf_group.h"
#include "csg/reference/mesh.h"

namespace csg::reference {

/// All leaves of the group at once, whatever the expression: the faces are cut up where they meet, plane by plane
/// (segments.h, plane_cells.h), the regions between them are found (cell_complex.h), and a cell is on the surface
/// exactly where the expression differs between the regions on its two sides. Geometry is decided by the two tables, of
/// planes and of points, and everything after that is combinatorial; where it does not fit together, Undecided is
/// thrown (plane_cells.h) rather than a wrong mesh returned. Sources are leaves of the group. Throws base::Stopped
/// where `stop` asked for it.
[[nodiscard]] Mesh plane_boolean(const LeafGroup& group, const GroupExpression& expression, unsigned threads,
                                 const std::stop_token& stop = {});

}  // namespace csg::reference
