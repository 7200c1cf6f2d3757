#include "base/exr.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string_view>

namespace base {
namespace {

constexpr std::size_t kShortName = 31;

/// Numbers as the file has them: little-endian.
void append(std::string& to, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) {
        to += static_cast<char>(value >> 8 * i & 255U);
    }
}

void append_int(std::string& to, std::uint32_t value) {
    append(to, value, 4);
}

void append_float(std::string& to, float value) {
    append_int(to, std::bit_cast<std::uint32_t>(value));
}

void append_name(std::string& to, std::string_view name) {
    to += name;
    to += '\0';
}

void append_attribute(std::string& to, std::string_view name, std::string_view type, std::string_view value) {
    append_name(to, name);
    append_name(to, type);
    append_int(to, static_cast<std::uint32_t>(value.size()));
    to += value;
}

}  // namespace

std::string encode_exr(const FloatImage& image) {
    std::vector<const FloatImage::Channel*> channels;
    for (const FloatImage::Channel& channel : image.channels) {
        channels.push_back(&channel);
    }
    std::sort(channels.begin(), channels.end(), [](const auto* a, const auto* b) { return a->name < b->name; });
    const bool long_names =
        std::any_of(channels.begin(), channels.end(), [](const auto* c) { return c->name.size() > kShortName; });

    std::string file;
    append_int(file, 20000630);  // The format's number.
    append_int(file, 2U | (long_names ? 0x400U : 0U));
    std::string list;
    for (const FloatImage::Channel* channel : channels) {
        constexpr std::uint32_t kFloat = 2;
        append_name(list, channel->name);
        append_int(list, kFloat);
        append_int(list, 0);  // Linear; three bytes are reserved.
        append_int(list, 1);  // A sample in each column …
        append_int(list, 1);  // … and each row.
    }
    list += '\0';
    append_attribute(file, "channels", "chlist", list);
    append_attribute(file, "compression", "compression", std::string_view("\0", 1));
    std::string window;
    append(window, 0, 8);
    append_int(window, static_cast<std::uint32_t>(image.width - 1));
    append_int(window, static_cast<std::uint32_t>(image.height - 1));
    append_attribute(file, "dataWindow", "box2i", window);
    append_attribute(file, "displayWindow", "box2i", window);
    append_attribute(file, "lineOrder", "lineOrder", std::string_view("\0", 1));
    std::string one;
    append_float(one, 1);
    append_attribute(file, "pixelAspectRatio", "float", one);
    append_attribute(file, "screenWindowCenter", "v2f", std::string(8, '\0'));
    append_attribute(file, "screenWindowWidth", "float", one);
    file += '\0';

    const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
    const std::size_t line = 4 * width * channels.size();
    const std::size_t first = file.size() + 8 * height;
    file.reserve(first + height * (8 + line));
    for (std::size_t y = 0; y < height; ++y) {
        append(file, first + y * (8 + line), 8);
    }
    for (std::size_t y = 0; y < height; ++y) {
        append_int(file, static_cast<std::uint32_t>(y));
        append_int(file, static_cast<std::uint32_t>(line));
        for (const FloatImage::Channel* channel : channels) {
            for (std::size_t x = 0; x < width; ++x) {
                append_float(file, channel->values[y * width + x]);
            }
        }
    }
    return file;
}

}  // namespace base
