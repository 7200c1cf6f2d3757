// Which side of its boundary a region lies on.
#pragma once

#include <polyclipping/clipper.hpp>

namespace csg::solid {

/// Turns the paths so that the region, which is what an odd number of them is around, lies to the left of each. Clipper
/// does so but for some paths that touch others; only those are looked at. Takes time for each of them along all edges.
void orient(ClipperLib::Paths& paths);

}  // namespace csg::solid
