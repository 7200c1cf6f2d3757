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
/// The same on a ground of another color than the tone of 0 (sRGB).
void draw_legend(base::Image& image, double full, const std::function<glm::vec3(float share)>& tone,
                 const glm::vec3& ground);

/// Draws a ring about the place (pixels from the upper left corner) with a text of digits and points beside it, so
/// many lines lower.
void draw_ring(base::Image& image, const glm::dvec2& at, std::string_view text, int lower = 0);

/// Between the numbers of a legend: 1, 2 or 5 times a power of ten, the least of which `full` holds at most five.
[[nodiscard]] double legend_step(double full);

/// Draws a bar of a round length, a quarter of the picture's width at most, into the lower left corner, with the length
/// in millimeters above it.
void draw_scale_bar(base::Image& image, double pixels_per_millimeter, const glm::vec3& ink);

/// Pixels at the lower border that the bar takes.
[[nodiscard]] int bar_strip(glm::ivec2 size);

/// The nearest number above that has two digits.
[[nodiscard]] double round_up(double thickness);

}  // namespace ui
