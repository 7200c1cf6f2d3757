// Offsets of lines and loops.
#pragma once

#include <cstdint>

#include "csg/solid/outline.h"

namespace csg::solid {

enum class Join : std::uint8_t { Miter, Round, Square };
enum class LineEnd : std::uint8_t { Closed, Butt, Round, Square };

struct Widening {
    double distance = 0;   ///< To the right of closed loops (outwards); on both sides of open lines.
    double tolerance = 0;  ///< Of arcs: how far chords lie within, at most a quarter of the distance.
    double miter_limit = 2;
    Join join = Join::Round;
    LineEnd end = LineEnd::Closed;
};

/// The region that is left when `loops` (of an Outline, or an open line) are widened, with the corners that Clipper 6
/// gives joins and ends. Closed: those of the region and what is swept when each edge moves outwards, with the joins
/// between; where the distance is negative, the region without what is swept inwards. Loops that are not finite are
/// left out. Throws OutlineError.
[[nodiscard]] Outline widen(std::span<const Loop> loops, const Widening& how);

}  // namespace csg::solid
