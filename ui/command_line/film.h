// The film that a run writes, frame by frame.
#pragma once

#include <deque>
#include <memory>
#include <stop_token>

#include "base/film_writer.h"
#include "ui/command_line/files.h"
#include "ui/command_line/options.h"

namespace ui {

/// The files are there whole, after finish(), or not at all.
class Film {
  public:
    /// To each output that is a film; the first time it begins them. Throws std::runtime_error, base::Stopped.
    void add(const Options& options, const base::Image& frame, double dots_per_inch, const std::stop_token& stop);
    /// Nothing where no frame was added.
    void finish();

  private:
    struct File {
        File(const Output& output, int frames, double rate);
        OutputFile file;
        std::unique_ptr<base::FilmWriter> film;
    };
    std::deque<File> files_;
};

}  // namespace ui
