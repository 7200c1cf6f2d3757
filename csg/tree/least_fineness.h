// How fine $fa and $fs can be.
#pragma once

namespace csg {

/// The least that an angle (degrees) or a length may be: OpenSCAD's. The language warns of less and takes this; a tree
/// that comes from elsewhere gets no finer either.
inline constexpr double kLeastFineness = 0.01;

}  // namespace csg
