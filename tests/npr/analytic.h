// What is seen of a model, ray by ray in double precision: the pictures that models of transparency are held to.
#pragma once

#include <functional>

#include "base/image.h"
#include "npr/picture.h"
#include "tests/goldfeather/comparison.h"

namespace analytic {

/// How far a picture is from what it is to be, in channels of bytes.
struct Error {
    double rms = 0;
    double most = 0;
    glm::ivec2 worst{0};     ///< The pixel that is so far off, from the upper left corner.
    std::size_t pixels = 0;  ///< Compared: those of rays that meet something, are not in the band, and whose
                             ///< surfaces are of one leaf each.
};

/// What rays see, one in the middle of each pixel.
struct Truth {
    glm::ivec2 size{0};
    std::vector<glm::dvec3> colors;  ///< Rows from top to bottom; sRGB.
    std::vector<char> compared;      ///< See Error::pixels.
};

/// `picture.transparency`: Exact or Volume.
[[nodiscard]] Truth truth_of(const comparison::Subject& subject, const npr::Picture& picture);

/// Compares a picture of one sample per pixel.
[[nodiscard]] Error error_of(const Truth& truth, const base::Image& image);
[[nodiscard]] Error error_of(const comparison::Subject& subject, const npr::Picture& picture, const base::Image& image);

}  // namespace analytic
