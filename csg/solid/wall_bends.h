// How much the walls of an extrusion bend from triangle to triangle. Internal to csg/solid.
#pragma once

#include <cstddef>

#include "csg/solid/outline_curves.h"
#include "csg/solid/solid.h"

namespace csg::solid {

/// `solid`: its triangles from `first` on are the walls, slice by slice, in each by loop and edge, two for each. Sets
/// their groups to those of the edges, with the angles that they have where slices turn or are scaled.
void group_walls(Solid& solid, std::size_t first, const OutlineCurves& curves, std::size_t slices);

}  // namespace csg::solid
