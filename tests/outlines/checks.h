// What an outline and the solids made from it must be.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "csg/solid/outline.h"

namespace outlines {

/// Makes the outline of polygon() from `loops` and solids from it: plain, scaled, twisted, revolved all the way and in
/// part. Empty where all is well: the rule of Outline; areas and volumes as the loops have by the even-odd rule; meshes
/// closed; points by the winding number of a mesh inside where the loops say so. Else what is wrong.
[[nodiscard]] std::string problem_of(const std::vector<csg::solid::Loop>& loops, std::uint64_t seed);

}  // namespace outlines
