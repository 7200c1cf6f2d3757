// Where the samples of a pixel lie.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "base/camera.h"
#include "npr/picture.h"

namespace npr {

/// How many samples a pixel may have.
inline constexpr std::array kSampleCounts{1, 4, 8, 16};

/// Offsets from the pixel's center, in pixels: 1 (the center), 4 (rotated grid), 8 or 16 (each row and each column of
/// the pixel's grid holds one). Other counts give the next larger set; counts above 16 give 16.
[[nodiscard]] std::span<const glm::dvec2> sample_offsets(int count);

/// The view of a picture's sample, one of sample_offsets(picture.samples).
[[nodiscard]] base::View sample_view(const Picture& picture, std::size_t sample, const glm::dvec3& lo,
                                     const glm::dvec3& hi);

}  // namespace npr
