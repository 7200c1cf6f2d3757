#include "base/image.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include "base/decode_png.h"
#include "base/stop.h"

namespace base {
namespace {

bool opaque(const Image& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        if (image.rgba[i] != 255) {
            return false;
        }
    }
    return true;
}

/// What libpng writes, and why it stopped. No exception may pass through its code.
struct Written {
    std::string bytes, problem;
    bool out_of_memory = false;
};

[[noreturn]] void note_problem(png_structp png, png_const_charp text) {
    static_cast<Written*>(png_get_error_ptr(png))->problem = text;
    png_longjmp(png, 1);
}

void append(png_structp png, png_bytep data, std::size_t size) {
    auto& written = *static_cast<Written*>(png_get_io_ptr(png));
    try {
        written.bytes.append(reinterpret_cast<const char*>(data), size);
    } catch (const std::bad_alloc&) {
        written.out_of_memory = true;
    }
    if (written.out_of_memory) {
        png_error(png, "out of memory");
    }
}

enum class Outcome { Done, Stopped, Failed };

/// How rows are told: as they are, or minus the row above.
enum class RowFilter : std::uint8_t { None, Up };

/// What repeats is what packing is about. In a drawing, pixels repeat as they are, and differences to the row above
/// hide it; in smooth shading rows resemble each other. So the one with fewer changes from pixel to pixel is taken;
/// libpng's own choice, row by row for the least differences, takes twice as long for larger files.
RowFilter better_filter(const Image& image) {
    std::size_t changes = 0, changes_of_differences = 0;
    for (int y = 1; y < image.height; ++y) {
        const std::uint8_t *row = image.pixel(0, y), *above = image.pixel(0, y - 1);
        for (int i = 4; i < 4 * image.width; i += 4) {
            int change = 0, change_of_differences = 0;
            for (int k = i; k < i + 4; ++k) {
                const int by = row[k] - row[k - 4];
                change |= by;
                change_of_differences |= by - (above[k] - above[k - 4]);
            }
            changes += change != 0 ? 1 : 0;
            changes_of_differences += change_of_differences != 0 ? 1 : 0;
        }
    }
    return 5 * changes_of_differences < 4 * changes ? RowFilter::Up : RowFilter::None;
}

/// Nothing here has a destructor that an error of libpng could jump over. `row`: room for one without alpha.
Outcome write_rows(png_structp png, png_infop info, const Image& image, bool alpha, RowFilter filter, std::uint8_t* row,
                   const std::stop_token& stop, png_uint_32 dots_per_meter) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return Outcome::Failed;
    }
    png_set_filter(png, PNG_FILTER_TYPE_BASE, filter == RowFilter::Up ? PNG_FILTER_UP : PNG_FILTER_NONE);
    png_set_compression_level(png, filter == RowFilter::Up ? 6 : 5);
    png_set_compression_strategy(png, 0);  // zlib's Z_DEFAULT_STRATEGY
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (dots_per_meter > 0) {
        png_set_pHYs(png, info, dots_per_meter, dots_per_meter, PNG_RESOLUTION_METER);
    }
    png_write_info(png, info);
    for (int y = 0; y < image.height; ++y) {
        if (stop.stop_requested()) {
            return Outcome::Stopped;
        }
        const std::uint8_t* pixels = image.pixel(0, y);
        if (!alpha) {
            for (int x = 0; x < image.width; ++x) {
                std::copy_n(pixels + 4 * x, 3, row + 3 * x);
            }
            pixels = row;
        }
        png_write_row(png, pixels);
    }
    png_write_end(png, info);
    return Outcome::Done;
}

void ignore_warning(png_structp, png_const_charp) {}

constexpr std::int64_t kMostPixels = 1 << 28;

/// Sets the size; the rows will be RGBA of 8 bits.
bool read_header(png_structp png, png_infop info, Image& image) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);  // Texts of any size that they claim.
    png_read_info(png, info);
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    image.width = static_cast<int>(png_get_image_width(png, info));
    image.height = static_cast<int>(png_get_image_height(png, info));
    return true;
}

bool read_rows(png_structp png, png_bytepp rows) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_read_image(png, rows);
    return true;
}

}  // namespace

std::string encode_png(const Image& image, const std::stop_token& stop, double dots_per_inch, PngChannels channels) {
    Written written;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &written, note_problem, nullptr);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    if (info == nullptr) {
        png_destroy_write_struct(&png, nullptr);
        throw std::bad_alloc();
    }
    png_set_write_fn(png, &written, append, nullptr);
    const bool alpha = channels == PngChannels::Rgba || !opaque(image);
    std::vector<std::uint8_t> row(static_cast<std::size_t>(image.width) * 3);
    const Outcome outcome = write_rows(png, info, image, alpha, better_filter(image), row.data(), stop,
                                       static_cast<png_uint_32>(std::lround(dots_per_inch / 0.0254)));
    png_destroy_write_struct(&png, &info);
    if (written.out_of_memory) {
        throw std::bad_alloc();
    }
    if (outcome == Outcome::Failed) {
        throw std::runtime_error("PNG: " + written.problem);
    }
    if (outcome == Outcome::Stopped) {
        throw Stopped();
    }
    return std::move(written.bytes);
}

namespace {

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Null: as errno says.
Image decode_file(const FilePointer& file, const std::string& name) {
    if (file == nullptr) {
        throw std::runtime_error(fmt::format("{}: {}", name, std::strerror(errno)));
    }
    Written failure;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure, note_problem, ignore_warning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    if (info == nullptr) {
        png_destroy_read_struct(&png, nullptr, nullptr);
        throw std::bad_alloc();
    }
    png_init_io(png, file.get());
    Image image;
    std::vector<png_bytep> rows;
    bool good = read_header(png, info, image);
    if (good && std::int64_t{image.width} * image.height > kMostPixels) {
        failure.problem = fmt::format("{} × {} pixels are more than can be read", image.width, image.height);
        good = false;
    }
    if (good) {
        try {
            image.rgba.resize(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
            for (int y = 0; y < image.height; ++y) {
                rows.push_back(const_cast<png_bytep>(image.pixel(0, y)));
            }
        } catch (const std::bad_alloc&) {
            png_destroy_read_struct(&png, &info, nullptr);
            throw;
        }
    }
    const bool read = good && read_rows(png, rows.data());
    png_destroy_read_struct(&png, &info, nullptr);
    if (!read) {
        throw std::runtime_error(fmt::format("{}: {}", name, failure.problem));
    }
    return image;
}

}  // namespace

Image read_png(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::exists(path, error) &&
        !std::filesystem::is_regular_file(path, error)) {  // To open a pipe would be to wait.
        throw std::runtime_error(fmt::format("{}: it is no regular file", path.string()));
    }
    return decode_file(FilePointer(std::fopen(path.c_str(), "rb"), std::fclose), path.string());
}

Image decode_png(std::string_view bytes, const std::string& name) {
    // It is only read from.
    return decode_file(FilePointer(fmemopen(const_cast<char*>(bytes.data()), bytes.size(), "rb"), std::fclose), name);
}

}  // namespace base
