#include "ui/viewer/settings.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "base/file.h"
#include "ui/viewer/mouse_preset.h"
#include "ui/viewer/recent_files.h"
#include "ui/viewer/window.h"

namespace ui {

namespace {

constexpr std::string_view kKey = "key ";

/// The nearest of those that are offered.
double text_size_of(const std::string& text) {
    const double wanted = std::strtod(text.c_str(), nullptr);
    return *std::min_element(std::begin(kTextSizes), std::end(kTextSizes),
                             [&](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
}

std::vector<Chord> chords_of(const std::string& text) {
    std::vector<Chord> chords;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find(", ", from), text.size());
        if (const auto chord = chord_of(text.substr(from, end - from))) {
            chords.push_back(*chord);
        }
        from = end + 2;
    }
    return chords;
}

void read_line(const std::string& name, const std::string& value, Settings& settings) {
    if (name == "mouse") {
        settings.mouse = mouse_preset(value);
    } else if (name == "theme") {
        settings.light = value == "light";
    } else if (name == "text size") {
        settings.text_size = text_size_of(value);
    } else if (name.starts_with(kKey)) {
        for (const ActionInfo& each : actions()) {
            if (name.substr(kKey.size()) == each.label) {
                settings.keys.set(each.action, chords_of(value));
            }
        }
    }
}

}  // namespace

Settings read_settings(const std::filesystem::path& file) {
    Settings settings;
    std::istringstream lines(file.empty() ? "" : base::read_regular_file(file).value_or(""));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t sign = line.find(" = ");
        if (sign != std::string::npos) {
            read_line(line.substr(0, sign), line.substr(sign + 3), settings);
        }
    }
    return settings;
}

void write_settings(const std::filesystem::path& file, const Settings& settings) {
    if (file.empty()) {
        return;
    }
    std::string text = fmt::format("mouse = {}\ntheme = {}\ntext size = {:g}\n", mouse_presets()[settings.mouse].name,
                                   settings.light ? "light" : "dark", settings.text_size);
    for (const auto& [action, chords] : settings.keys.changed()) {
        const auto info = std::find_if(actions().begin(), actions().end(),
                                       [action = action](const ActionInfo& each) { return each.action == action; });
        std::string keys;
        for (const Chord& chord : chords) {
            keys += (keys.empty() ? "" : ", ") + ui::text(chord);
        }
        text += fmt::format("{}{} = {}\n", kKey, info->label, keys);
    }
    try {
        base::make_folder(file.parent_path());
        base::write_file(file, text);
    } catch (const std::runtime_error&) {
        // They hold for this run.
    }
}

std::filesystem::path settings_file() {
    const std::filesystem::path recent = RecentFiles::state_file();
    return recent.empty() ? recent : recent.parent_path() / "settings";
}

}  // namespace ui
