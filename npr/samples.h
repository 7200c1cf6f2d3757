// Where the samples of a pixel lie.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "base/camera.h"
#include "npr/picture.h"

namespace npr {

/// How many samples a pixel may have.
inline constexpr std::array kSampleCounts{1, 4, 8, 16, 64, 256};

/// Offsets from the pixel's center, in pixels: 1 (the center), 4 (rotated grid), or more (each row and each column of
/// the pixel's grid holds one; of 64 and 256 each cell of a grid of 8 by 8 or 16 by 16, too). Other counts give the
/// next larger set; counts above 256 give 256.
[[nodiscard]] std::span<const glm::dvec2> sample_offsets(int count);

/// The view of a picture's sample, one of sample_offsets(picture.samples).
[[nodiscard]] base::View sample_view(const Picture& picture, std::size_t sample, const glm::dvec3& lo,
                                     const glm::dvec3& hi);

}  // namespace npr
