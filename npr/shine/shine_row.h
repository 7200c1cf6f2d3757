// npr/shine/shine_row.glsl in C++.
#pragma once

#include <glm/glm.hpp>

namespace npr {

using glm::uint;

#include "npr/shine/shine_row.glsl"

}  // namespace npr
