#include "gl/image.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <fmt/format.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
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

void write_file(const std::filesystem::path& path, const std::string& bytes) {
    std::string temporary = (path.parent_path() / fmt::format(".{}.XXXXXX", path.filename().string())).string();
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
