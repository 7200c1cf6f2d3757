#pragma once

namespace csg::solid {

/// Smaller circles are three points, smaller helices one slice: OpenSCAD's GRID_FINE.
inline constexpr double kSmallestRadius = 0x1p-20;

}  // namespace csg::solid
