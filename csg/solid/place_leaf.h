// One leaf in the world. Internal to csg/solid.
#pragma once

#include <string>

#include "csg/solid/placed.h"

namespace csg::solid {

/// Has the box an extent along each axis?
[[nodiscard]] bool has_volume(const Box& box);

/// Of the corners of a box that is not empty, the largest absolute value.
[[nodiscard]] double largest_coordinate(const Box& box);

/// Takes all surfaces from the leaf.
void leave_out(PlacedLeaf& leaf);

/// Places `leaf.solid`; the leaf must have no points yet. Leaves it empty where it cannot be placed; gives the failure,
/// where it should not be so. `flat`: as in place().
[[nodiscard]] std::string place_leaf(const LeafInstance& instance, double flat, PlacedLeaf& leaf);

/// What is wrong with the size of a leaf by itself, for the user; empty where nothing is. `largest`: its largest
/// coordinate.
[[nodiscard]] std::string fault_of_size(const PlacedLeaf& leaf, double largest);

}  // namespace csg::solid
