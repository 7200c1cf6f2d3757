#include "gl/image.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <stdexcept>

namespace gl {
namespace {

bool opaque(const Image& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        if (image.rgba[i] != 255)
            return false;
    return true;
}

}  // namespace

std::string encode_png(const Image& image) {
    std::vector<std::uint8_t> rgb;
    const void* pixels = image.rgba.data();
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGBA;
    if (opaque(image)) {
        png.format = PNG_FORMAT_RGB;
        rgb.resize(image.rgba.size() / 4 * 3);
        for (std::size_t i = 0; i < rgb.size() / 3; ++i)
            std::copy_n(&image.rgba[4 * i], 3, &rgb[3 * i]);
        pixels = rgb.data();
    }
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels, 0, nullptr))
        throw std::runtime_error(std::string("PNG: ") + png.message);
    bytes.resize(size);
    return bytes;
}

Image read_png(const std::filesystem::path& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, path.c_str()))
        throw std::runtime_error(fmt::format("{}: {}", path.string(), png.message));
    png.format = PNG_FORMAT_RGBA;
    Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
    image.rgba.resize(PNG_IMAGE_SIZE(png));
    if (!png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr))
        throw std::runtime_error(fmt::format("{}: {}", path.string(), png.message));
    return image;
}

}  // namespace gl
