// The region that a line of some width covers.
#pragma once

#include "csg/solid/outline.h"

namespace csg::solid {

struct Stroke {
    enum class Cap : std::uint8_t { Butt, Round, Square };
    enum class Join : std::uint8_t { Miter, Round, Bevel };
    double width = 1;
    Cap cap = Cap::Butt;
    Join join = Join::Miter;
    double miter_limit = 2;  ///< Longest miter over the width, at least 2; what would be longer is cut off.
};

/// Of an open line; `around`: corners of a whole turn where joins or caps are round. Empty where the width is not above
/// 0. Throws OutlineError where coordinates are beyond what can be worked with.
[[nodiscard]] Outline stroke(const Loop& line, const Stroke& how, int around);

}  // namespace csg::solid
