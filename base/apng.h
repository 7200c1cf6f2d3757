// Films as animated PNG: any program that shows PNG shows the first frame, browsers and most viewers all of them.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string_view>

#include "base/image.h"

namespace base {

/// Writes frame by frame; of each only the rectangle that differs from the one before. The same frames give the same
/// bytes.
class ApngWriter {
  public:
    /// `write` is given the bytes of the file in their order. `frames`: how many there will be, at least 1; each is
    /// shown for 1/`frames_per_second`, and after the last the first again.
    ApngWriter(std::function<void(std::string_view)> write, int frames, double frames_per_second);

    /// All frames have one size. Throws Stopped where `stop` asked for it, std::runtime_error where the size differs or
    /// there are more frames than were told.
    void add(const Image& frame, const std::stop_token& stop = {}, double dots_per_inch = 0);
    /// After the last frame. Throws std::runtime_error where frames are missing.
    void finish();

  private:
    void write_chunk(std::string_view kind, std::string_view data);
    void write_control(int x, int y, int width, int height);

    std::function<void(std::string_view)> write_;
    int frames_;
    double frames_per_second_;
    int added_ = 0;
    std::uint32_t sequence_ = 0;
    Image last_;
};

}  // namespace base
