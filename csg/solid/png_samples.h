// The numbers in a PNG file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace csg::solid {

/// Samples of red, green and blue from 0 to 1, three a pixel, rows from the top. They are what the file has, as linear
/// numbers: what it says of gamma or color spaces does not count, nor does transparency.
struct PngSamples {
    std::size_t columns = 0, rows = 0;
    std::vector<double> values;
    std::string problem;  ///< Why there are none; empty where all is well.
};

/// Of any kind of PNG: 1 to 16 bits, gray, color or palette, interlaced or not. More than `most` pixels are a problem.
[[nodiscard]] PngSamples read_png(std::string_view bytes, std::size_t most);

}  // namespace csg::solid
