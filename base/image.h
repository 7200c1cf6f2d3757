// Pictures in memory and in PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace base {

/// 8-bit sRGB with straight alpha, rows from top to bottom.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;

    [[nodiscard]] const std::uint8_t* pixel(int x, int y) const {
        return &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
    }
};

enum class PngChannels {
    AsNeeded,  ///< RGB where every pixel is opaque, RGBA otherwise.
    Rgba,
};

/// The bytes of a PNG file. The same image gives the same bytes. Throws Stopped where `stop` asked for it.
/// `dots_per_inch`: written as the picture's resolution; 0: none is.
[[nodiscard]] std::string encode_png(const Image& image, const std::stop_token& stop = {}, double dots_per_inch = 0,
                                     PngChannels channels = PngChannels::AsNeeded);

/// Reads a PNG of any kind as RGBA: the numbers that it has, whatever it says of gamma. Throws std::runtime_error with
/// the reason, also where it has more than 2^28 pixels.
[[nodiscard]] Image read_png(const std::filesystem::path& path);

}  // namespace base
