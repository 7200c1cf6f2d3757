// How many slices an extrusion has.
#pragma once

#include <cstddef>

#include "csg/solid/outline.h"

namespace csg::solid {

/// slice_count() is never more; where it is this, more may have been asked for.
inline constexpr double kMostSlices = 1 << 20;

/// OpenSCAD's rule for linear_extrude(): as given, or so that no edge along the sweep is longer than $fs (or turns by
/// more than $fa), or is further than $fe from its helix, or $fn for a whole turn; at least three for a whole turn.
[[nodiscard]] std::size_t slice_count(const Outline& outline, const LinearExtrude& how);

}  // namespace csg::solid
