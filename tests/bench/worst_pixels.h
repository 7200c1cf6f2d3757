// The worst pixels of methods, enlarged, beside what rays see there.
#pragma once

#include <string>
#include <vector>

#include "tests/npr/analytic.h"

namespace bench {

/// What is about a method's worst pixel, and the same as rays see it.
struct WorstPixel {
    std::vector<std::uint8_t> seen, expected;  ///< RGB, kSide rows of kSide pixels, from top to bottom.
    static constexpr int kSide = 9;
};

[[nodiscard]] WorstPixel worst_pixel(const analytic::Truth& truth, const base::Image& image,
                                     const analytic::Error& error);

/// All beside each other, enlarged: above what the methods show, below what rays see, the worst pixel framed in the
/// middle.
[[nodiscard]] base::Image sheet_of(const std::vector<WorstPixel>& pixels);

}  // namespace bench
