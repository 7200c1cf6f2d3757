// Leaves of several shells that cannot meet, taken apart.
#pragma once

#include <stop_token>
#include <vector>

#include "csg/solid/placed.h"

namespace csg::reference {

/// The leaf's shells (triangles joined by points that are equal), those together whose boxes come as near as `margin`
/// to each other, directly or through others: what is inside the leaf is inside one of them, by the same rule. In the
/// order of their first triangles. Empty where there is but one. Throws base::Stopped.
[[nodiscard]] std::vector<solid::PlacedLeaf> pieces_of(const solid::PlacedLeaf& leaf, double margin,
                                                       const std::stop_token& stop);

}  // namespace csg::reference
