#include "base/apng.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace base {
namespace {

std::string big_endian(std::uint32_t value, int bytes = 4) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) {
        text += static_cast<char>(value >> (8 * i) & 255U);
    }
    return text;
}

std::uint32_t number_at(std::string_view png, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = value << 8 | static_cast<unsigned char>(png[at + i]);
    }
    return value;
}

Image part_of(const Image& image, const ImageRectangle& r) {
    Image part{r.width, r.height, {}};
    part.rgba.reserve(4 * static_cast<std::size_t>(r.width) * static_cast<std::size_t>(r.height));
    for (int y = r.y; y < r.y + r.height; ++y) {
        const std::uint8_t* row = image.pixel(r.x, y);
        part.rgba.insert(part.rgba.end(), row, row + 4 * r.width);
    }
    return part;
}

constexpr std::size_t kSignature = 8;

}  // namespace

ApngWriter::ApngWriter(WriteBytes write, int frames, double frames_per_second)
    : write_(std::move(write)), frames_(frames), frames_per_second_(frames_per_second) {}

void ApngWriter::add(const Image& frame, const std::stop_token& stop, double dots_per_inch) {
    const bool first = added_ == 0;
    if (added_ == frames_ || (!first && (frame.width != last_.width || frame.height != last_.height))) {
        throw std::runtime_error("APNG: frames of one size, and no more than were told, make a film");
    }
    const ImageRectangle r = first ? ImageRectangle{0, 0, frame.width, frame.height} : difference(last_, frame);
    const std::string png = encode_png(first ? frame : part_of(frame, r), stop, dots_per_inch, PngChannels::Rgba);
    if (first) {
        write_(std::string_view(png).substr(0, kSignature));
    }
    bool before_data = true;
    for (std::size_t at = kSignature; at < png.size();) {
        const std::size_t length = number_at(png, at);
        const std::string_view kind = std::string_view(png).substr(at + 4, 4);
        const std::string_view data = std::string_view(png).substr(at + 8, length);
        if (kind == "IDAT") {
            if (before_data) {
                if (first) {
                    write_chunk("acTL", big_endian(static_cast<std::uint32_t>(frames_)) + big_endian(0));
                }
                write_control(r.x, r.y, r.width, r.height);
                before_data = false;
            }
            first ? write_chunk("IDAT", data) : write_chunk("fdAT", big_endian(sequence_++) + std::string(data));
        } else if (first && kind != "IEND") {
            write_chunk(kind, data);
        }
        at += 12 + length;
    }
    last_ = frame;
    ++added_;
}

void ApngWriter::finish() {
    if (added_ != frames_) {
        throw std::runtime_error("APNG: frames are missing");
    }
    write_chunk("IEND", {});
}

void ApngWriter::write_chunk(std::string_view kind, std::string_view data) {
    std::string chunk = std::string(kind) + std::string(data);
    const auto crc =
        crc32(crc32(0, nullptr, 0), reinterpret_cast<const Bytef*>(chunk.data()), static_cast<uInt>(chunk.size()));
    write_(big_endian(static_cast<std::uint32_t>(data.size())) + chunk + big_endian(static_cast<std::uint32_t>(crc)));
}

/// The frame's pixels take the place of those before; it is shown for a delay of two whole numbers' ratio.
void ApngWriter::write_control(int x, int y, int width, int height) {
    constexpr double kThousandths = 1000;
    const auto delay =
        static_cast<std::uint32_t>(std::clamp(std::lround(kThousandths / frames_per_second_), 1L, 65535L));
    std::string data = big_endian(sequence_++);
    for (const int value : {width, height, x, y}) {
        data += big_endian(static_cast<std::uint32_t>(value));
    }
    data += big_endian(delay, 2) + big_endian(static_cast<std::uint32_t>(kThousandths), 2) + std::string(2, '\0');
    write_chunk("fcTL", data);
}

}  // namespace base
