#include "ui/command_line/film.h"

#include <algorithm>

namespace ui {

Film::File::File(const std::string& path, int frames, double rate)
    : file(path), film([this](std::string_view bytes) { file.write(bytes); }, frames, rate) {}

void Film::add(const Options& options, const base::Image& frame, double dots_per_inch, const std::stop_token& stop) {
    if (files_.empty()) {
        const int frames = std::max(1, options.end_frame - options.first_frame);
        for (const Output& output : options.outputs) {
            if (output.format == Format::Apng) {
                files_.emplace_back(output.path, frames, options.frames_per_second);
            }
        }
    }
    for (File& each : files_) {
        each.film.add(frame, stop, dots_per_inch);
    }
}

void Film::finish() {
    for (File& each : files_) {
        each.film.finish();
        each.file.finish();
    }
    files_.clear();
}

}  // namespace ui
