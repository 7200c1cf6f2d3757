#include "ui/command_line/window_run.h"

#include <cstdlib>

#include "ui/command_line/depicting.h"
#include "ui/command_line/files.h"
#include "ui/command_line/standard_streams.h"
#include "ui/viewer/window.h"

namespace ui {

bool has_display() {
    const auto is_set = [](const char* name) {
        const char* const value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

int open_window(const Options& options) {
    if (!options.changes_from.empty()) {
        throw UsageError("--changes-from is of pictures: write one with -o");
    }
    if (!(options.explain.empty() && options.without.empty()) || options.thickness) {
        throw UsageError("--explain, --without and --thickness are of pictures: write one with -o");
    }
    WindowOptions window;
    window.source.path = options.input;
    if (options.input == "-") {
        window.source.text = read_standard_input();
    } else if (!options.input.empty()) {
        (void)read_source(options.input);  // A file that is not there is told before a window opens.
    }
    window.source.definitions = options.definitions;
    window.source.preview = options.preview;
    window.source.hard_warnings = options.hard_warnings;
    window.source.by_error = options.by_error;
    window.source.lazy_union = options.lazy_union;
    window.source.parts = options.parts;
    window.source.sections = options.picture.sections;
    window.camera = {options.camera,   options.projection,
                     options.view_all, options.autocenter,
                     options.margin,   static_cast<double>(options.picture.size.x) / options.picture.size.y};
    window.picture = PictureRequest(picture_of(options.picture, options.picture_texts));  // Told before a window opens.
    window.picture.engine = options.engine.engine;
    window.engine = options.engine;
    window.frames_log = options.frames_log;
    window.settings = settings_file();
    window.glyphs.annotations = options.annotations;
    (void)annotations_of(options.annotations);  // Errors are told before a window opens, …
    (void)rules_of(options);                    // … those of rules, too.
    window.glyphs.rules_file = options.depiction_rules;
    for (const Depiction& d : options.depictions) {
        window.glyphs.depictions.push_back(d.text);
    }
    if (run_window(window) == WindowEnd::StillDrawing) {
        std::_Exit(0);  // Nobody waits for that picture any more.
    }
    return 0;
}

}  // namespace ui
