// Booleans by an arrangement in exact arithmetic: slower than that of canonical planes, and never at a loss.
#pragma once

#include <stop_token>

#include "csg/reference/expression_value.h"
#include "csg/reference/leaf_group.h"
#include "csg/reference/mesh.h"

namespace csg::reference {

/// All leaves of the group at once, as plane_boolean, with coordinates taken to the last bit (corners that a few units
/// in the last place keep apart are one): triangles meet in segments between exact points (exact_faces.h,
/// exact_segments.h), planes and space are cut up along them and the cells with the solid on one side are the surface.
/// Coordinates are rounded at the end; edges that have no length then are collapsed where the mesh stays manifold, and
/// pieces that are nothing but rounding are dropped. Any leaves whose edges balance (of others: are even in number)
/// have a result, which is closed and manifold. Throws base::Stopped where it was asked for.
[[nodiscard]] Mesh exact_boolean(const LeafGroup& group, const GroupExpression& expression, unsigned threads,
                                 const std::stop_token& stop = {});

}  // namespace csg::reference
