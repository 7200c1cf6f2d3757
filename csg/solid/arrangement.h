// Edges that cross, touch and overlap in any way become edges that meet in their ends only.
#pragma once

#include <vector>

#include "csg/solid/grid_point.h"

namespace csg::solid {

/// The planar arrangement of `edges`, rounded to the grid (snap rounding, Hobby 1999: each edge is drawn through the
/// grid points whose unit squares it passes, as far as something ends or crosses in them; so no edge moves over a
/// point, and what is left does not cross). Sorted; edges in the same place are one, with the sum of their weights;
/// those of no weight are left out. Coordinates stay within ±2^41. Throws OutlineError beyond what can be worked with.
[[nodiscard]] std::vector<GridEdge> arrange(std::vector<GridEdge> edges);

/// Sorts, makes one of edges in the same place, and drops those of no weight.
void merge(std::vector<GridEdge>& edges);

}  // namespace csg::solid
