// What of a picture is not background, and how much of it two pictures share.
#pragma once

#include <vector>

#include "base/image.h"

namespace pictures {

/// The commonest color along the border, alpha left out.
struct Background {
    int r = 0, g = 0, b = 0;
    bool operator==(const Background&) const = default;
};
[[nodiscard]] Background background(const base::Image& image);

/// By pixel, rows from top to bottom: true where some channel is farther than 3 of 255 from the background's.
[[nodiscard]] std::vector<bool> silhouette(const base::Image& image, const Background& background);

/// Intersection over union of the silhouettes against the background of `expected`: 1 where both are empty, 0 where
/// sizes differ.
[[nodiscard]] double overlap(const base::Image& expected, const base::Image& drawn);

/// Black where both silhouettes agree; red where only `expected` has something, green where only `drawn` has.
[[nodiscard]] base::Image difference(const base::Image& expected, const base::Image& drawn);

}  // namespace pictures
