// What others need to know of the style "radiograph".
#pragma once

#include <glm/glm.hpp>

namespace npr {

/// The sRGB color of a share (0 to 1) of the full tone; `colors`: the style's parameter of that name.
[[nodiscard]] glm::vec3 radiograph_tone(int colors, float share);

}  // namespace npr
