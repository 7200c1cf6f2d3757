// OpenEXR files: pictures of 32-bit floats.
#pragma once

#include <string>
#include <vector>

namespace base {

/// Rows from top to bottom.
struct FloatImage {
    struct Channel {
        std::string name;           ///< Not empty, at most 255 bytes; no two are the same.
        std::vector<float> values;  ///< Row by row.
    };
    int width = 0, height = 0;
    std::vector<Channel> channels;
};

/// The bytes of a file of scan lines, not compressed, in the format's own order of channels, which is that of their
/// names.
[[nodiscard]] std::string encode_exr(const FloatImage& image);

}  // namespace base
