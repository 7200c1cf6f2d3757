// Films, whatever their format.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string_view>

#include "base/image.h"

namespace base {

/// Frames one after another; the same frames give the same bytes.
class FilmWriter {
  public:
    FilmWriter() = default;
    virtual ~FilmWriter() = default;
    FilmWriter(const FilmWriter&) = delete;
    FilmWriter& operator=(const FilmWriter&) = delete;

    /// All frames have one size. Throws Stopped where `stop` asked for it, std::runtime_error where the size differs or
    /// there are more frames than were told.
    virtual void add(const Image& frame, const std::stop_token& stop, double dots_per_inch) = 0;
    /// After the last frame. Throws std::runtime_error where frames are missing.
    virtual void finish() = 0;
};

/// Is given the bytes of a file in their order.
using WriteBytes = std::function<void(std::string_view)>;

/// A rectangle of an image: pixels from the upper left corner.
struct ImageRectangle {
    int x = 0, y = 0, width = 1, height = 1;
};

/// The least that holds every pixel in which two images of one size differ; a pixel where none does.
[[nodiscard]] ImageRectangle difference(const Image& a, const Image& b);

/// Animated GIF: 256 colors a frame, the nearest to those there are (median cut, Heckbert 1982); where there are no
/// more than that, exactly these. `frames`, `frames_per_second`: as of ApngWriter, in steps of 1/100 s. Opacity is all
/// or nothing.
[[nodiscard]] std::unique_ptr<FilmWriter> gif_writer(WriteBytes write, int frames, double frames_per_second);

/// Animated WebP, lossless with opacity. Written when it is finished.
[[nodiscard]] std::unique_ptr<FilmWriter> webp_writer(WriteBytes write, int frames, double frames_per_second);

}  // namespace base
