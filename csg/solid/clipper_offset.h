// Offsets of lines and loops, by Clipper.
#pragma once

#include <cstdint>

#include "csg/solid/outline.h"

namespace csg::solid {

enum class Join : std::uint8_t { Miter, Round, Square };
enum class LineEnd : std::uint8_t { Closed, Butt, Round, Square };

struct Widening {
    double distance = 0;   ///< To the right of closed loops (outwards); on both sides of open lines.
    double tolerance = 0;  ///< Of arcs.
    double miter_limit = 2;
    Join join = Join::Round;
    LineEnd end = LineEnd::Closed;
};

/// The region that is left when `loops` (of an Outline, or an open line) are widened. Throws OutlineError.
[[nodiscard]] Outline widen(std::span<const Loop> loops, const Widening& how);

}  // namespace csg::solid
