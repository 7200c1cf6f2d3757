#include "ui/command_line/film.h"

#include <algorithm>
#include <utility>

#include "base/apng.h"

namespace ui {

namespace {

std::unique_ptr<base::FilmWriter> writer_of(Format format, base::WriteBytes write, int frames, double rate) {
    switch (format) {
        case Format::Gif:
            return base::gif_writer(std::move(write), frames, rate);
        case Format::WebP:
            return base::webp_writer(std::move(write), frames, rate);
        default:
            return std::make_unique<base::ApngWriter>(std::move(write), frames, rate);
    }
}

}  // namespace

Film::File::File(const Output& output, int frames, double rate)
    : file(output.path),
      film(writer_of(
          output.format, [this](std::string_view bytes) { file.write(bytes); }, frames, rate)) {}

void Film::add(const Options& options, const base::Image& frame, double dots_per_inch, const std::stop_token& stop) {
    if (files_.empty()) {
        const int frames = std::max(1, options.end_frame - options.first_frame);
        for (const Output& output : options.outputs) {
            if (is_film(output.format)) {
                files_.emplace_back(output, frames, options.frames_per_second);
            }
        }
    }
    for (File& each : files_) {
        each.film->add(frame, stop, dots_per_inch);
    }
}

void Film::finish() {
    for (File& each : files_) {
        each.film->finish();
        each.file.finish();
    }
    files_.clear();
}

}  // namespace ui
