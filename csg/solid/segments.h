// How the edges of an extruded outline are divided, where its walls are bent.
#pragma once

#include <cstddef>

#include "csg/solid/outline.h"
#include "csg/tree/mesh_operation.h"

namespace csg::solid {

/// The outline with corners added on its edges, by OpenSCAD's rules: up to `segments` corners for each loop where that
/// is given (0: none are added); else, where the extrusion twists or scales unevenly, up to $fn corners, or edges no
/// longer than $fs but no more than $fa asks for around a circle. Longer edges, as they are at their longest between
/// bottom and top, are divided first.
[[nodiscard]] Outline divide_edges(const Outline& outline, const LinearExtrude& how, std::size_t slices);

}  // namespace csg::solid
