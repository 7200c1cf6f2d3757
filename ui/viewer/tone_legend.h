// A column of tones over the picture, with lengths beside it.
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "ui/viewer/layout.h"
#include "ui/viewer/theme.h"

namespace ui {

/// In the lower left corner of the picture, beside the axes: from 0 to `full` mm. `tone`: the sRGB color of a share of
/// that. `ground`: of the picture, sRGB. Nothing where the picture is too small.
void draw_tone_legend(const Rectangle& place, double full, const std::function<glm::vec3(float share)>& tone,
                      const glm::vec3& ground, const Fonts& fonts, float scale);

}  // namespace ui
