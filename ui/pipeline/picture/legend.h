// The legend of a radiograph.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string_view>

#include "base/image.h"

namespace ui {

/// Draws a column of tones into the lower left corner of the picture, from 0 to `full` millimeters, with numbers beside
/// it at round thicknesses. `tone`: the sRGB color of a share of the full tone. Pictures too small for it stay as they
/// are.
void draw_legend(base::Image& image, double full, const std::function<glm::vec3(float share)>& tone);

/// The nearest number above that has two digits.
[[nodiscard]] double round_up(double thickness);

}  // namespace ui
