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
    std::size_t pixels = 0;  ///< Compared: those of rays that meet something, are not in the band, and whose
                             ///< surfaces are of one leaf each.
};

/// Compares a picture of one sample per pixel. `picture.transparency`: Exact or Volume.
[[nodiscard]] Error error_of(const comparison::Subject& subject, const npr::Picture& picture, const base::Image& image);

}  // namespace analytic
