#include "csg/solid/png_samples.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstdint>
#include <cstring>

namespace csg::solid {
namespace {

/// Nothing in here needs to be destroyed when libpng jumps out of what it was called for.
struct Reading {
    std::string_view left;
    std::size_t most = 0;
    char message[128] = {};
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::size_t columns = 0, rows = 0, channels = 0, bits = 0;
    std::vector<png_byte> bytes;
    std::vector<png_bytep> lines;
};

void fail(png_structp png, png_const_charp message) {
    auto* reading = static_cast<Reading*>(png_get_error_ptr(png));
    std::strncpy(reading->message, message, sizeof reading->message - 1);
    png_longjmp(png, 1);
}

void read_bytes(png_structp png, png_bytep data, std::size_t size) {
    auto* reading = static_cast<Reading*>(png_get_io_ptr(png));
    if (size > reading->left.size()) {
        png_error(png, "the file ends too early");
    }
    std::memcpy(data, reading->left.data(), size);
    reading->left.remove_prefix(size);
}

bool read_rows(Reading& reading) {
    png_structp png = reading.png;
    png_infop info = reading.info;
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_set_read_fn(png, &reading, read_bytes);
    // What is beside the picture is passed over: a text may claim 2 GB, which libpng takes before it reads.
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_read_info(png, info);
    reading.columns = png_get_image_width(png, info);
    reading.rows = png_get_image_height(png, info);
    if (reading.rows > 0 && reading.columns > reading.most / reading.rows) {
        return false;
    }
    png_set_expand(png);  // Palettes to colors, 1, 2 and 4 bits to 8.
    png_set_strip_alpha(png);
    png_set_gray_to_rgb(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    reading.channels = png_get_channels(png, info);
    reading.bits = png_get_bit_depth(png, info);
    const std::size_t width = png_get_rowbytes(png, info);
    reading.bytes.resize(width * reading.rows);
    for (std::size_t y = 0; y < reading.rows; ++y) {
        reading.lines.push_back(reading.bytes.data() + y * width);
    }
    png_read_image(png, reading.lines.data());
    return true;
}

}  // namespace

PngSamples read_png(std::string_view bytes, std::size_t most) {
    PngSamples samples;
    Reading reading;
    reading.left = bytes;
    reading.most = most;
    reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, fail, [](png_structp, png_const_charp) {});
    if (reading.png != nullptr) {
        reading.info = png_create_info_struct(reading.png);
    }
    const bool good = reading.info != nullptr && read_rows(reading);
    png_destroy_read_struct(&reading.png, &reading.info, nullptr);
    if (!good) {
        samples.problem = reading.message[0] != '\0'
                              ? fmt::format("Can't read surface picture: {}", reading.message)
                              : fmt::format("surface picture of {} × {} pixels is too large; it is left out",
                                            reading.columns, reading.rows);
        return samples;
    }
    samples.columns = reading.columns;
    samples.rows = reading.rows;
    const std::size_t wide = reading.bits == 16 ? 2 : 1;
    const double largest = reading.bits == 16 ? 65535 : 255;
    samples.values.reserve(reading.columns * reading.rows * 3);
    for (const png_byte* line : reading.lines) {
        for (std::size_t i = 0; i < reading.columns; ++i) {
            const png_byte* pixel = line + i * reading.channels * wide;
            for (std::size_t k = 0; k < 3; ++k) {
                const png_byte* sample = pixel + std::min(k, reading.channels - 1) * wide;
                samples.values.push_back((wide == 2 ? sample[0] * 256 + sample[1] : sample[0]) / largest);
            }
        }
    }
    return samples;
}

}  // namespace csg::solid
