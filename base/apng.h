// Films as animated PNG: any program that shows PNG shows the first frame, browsers and most viewers all of them.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string_view>

#include "base/film_writer.h"

namespace base {

/// Writes frame by frame; of each only the rectangle that differs from the one before.
class ApngWriter final : public FilmWriter {
  public:
    /// `write` is given the bytes of the file in their order. `frames`: how many there will be, at least 1; each is
    /// shown for 1/`frames_per_second`, and after the last the first again.
    ApngWriter(WriteBytes write, int frames, double frames_per_second);

    void add(const Image& frame, const std::stop_token& stop = {}, double dots_per_inch = 0) override;
    void finish() override;

  private:
    void write_chunk(std::string_view kind, std::string_view data);
    void write_control(int x, int y, int width, int height);

    WriteBytes write_;
    int frames_;
    double frames_per_second_;
    int added_ = 0;
    std::uint32_t sequence_ = 0;
    Image last_;
};

}  // namespace base
