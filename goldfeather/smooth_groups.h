// Which smooth surfaces of its leaf a plane belongs to, for whoever draws lines.
#pragma once

#include <cstdint>
#include <vector>

#include "csg/solid/placed.h"

namespace goldfeather {

/// The table of layers/smooth_groups.glsl.
[[nodiscard]] std::vector<std::uint32_t> smooth_groups(const csg::solid::Geometry& geometry);

}  // namespace goldfeather
