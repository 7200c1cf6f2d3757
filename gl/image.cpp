#include "gl/image.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <fmt/format.h>
#include <png.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace gl {
namespace {

[[noreturn]] void png_failed(png_structp png, png_const_charp message) {
    *static_cast<std::string*>(png_get_error_ptr(png)) = message;
    png_longjmp(png, 1);
}

void png_warned(png_structp, png_const_charp) {}

void append_bytes(png_structp png, png_bytep data, png_size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

bool opaque(const Image& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        if (image.rgba[i] != 255)
            return false;
    return true;
}

}  // namespace

std::string encode_png(const Image& image) {
    std::string bytes, error;
    const bool rgb = opaque(image);
    const auto width = static_cast<std::size_t>(image.width);
    std::vector<std::uint8_t> row(width * 4);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, png_failed, png_warned);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png))) {
        png_destroy_write_struct(&png, &info);
        throw std::runtime_error("PNG: " + error);
    }
    png_set_write_fn(png, &bytes, append_bytes, nullptr);
    png_set_compression_level(png, 6);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 rgb ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* from = image.pixel(0, y);
        if (rgb) {
            for (std::size_t x = 0; x < width; ++x)
                std::memcpy(&row[3 * x], from + 4 * x, 3);
            png_write_row(png, row.data());
        } else {
            png_write_row(png, from);
        }
    }
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
    std::string temporary = (path.parent_path() / ("." + path.filename().string() + ".XXXXXX")).string();
    const auto fail = [&](const char* what) {
        throw std::runtime_error(fmt::format("{}: {}: {}", path.string(), what, std::strerror(errno)));
    };
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored)) {
        // A device or a pipe cannot be replaced; it is written to.
        const int fd = open(path.c_str(), O_WRONLY);
        if (fd < 0)
            fail("cannot be written");
        const bool ok = ::write(fd, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
        if (close(fd) != 0 || !ok)
            fail("cannot be written");
        return;
    }
    const int fd = mkstemp(temporary.data());
    if (fd < 0)
        fail("cannot be created");
    const auto give_up = [&](const char* what) {
        const int reason = errno;
        close(fd);
        unlink(temporary.c_str());
        errno = reason;
        fail(what);
    };
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t n = ::write(fd, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            give_up("cannot be written");
        done += static_cast<std::size_t>(n);
    }
    const mode_t mask = umask(0);
    umask(mask);
    if (fchmod(fd, 0666 & ~mask) != 0)
        give_up("cannot be written");
    if (close(fd) != 0) {
        unlink(temporary.c_str());
        fail("cannot be written");
    }
    if (rename(temporary.c_str(), path.c_str()) != 0) {
        const int reason = errno;
        unlink(temporary.c_str());
        errno = reason;
        fail("cannot be created");
    }
}

Image read_png(const std::filesystem::path& path) {
    png_image png;
    std::memset(&png, 0, sizeof png);
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
