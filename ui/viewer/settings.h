// What the user has chosen for all runs, kept beside the recent files.
#pragma once

#include <cstddef>
#include <filesystem>

#include "ui/viewer/keys.h"

namespace ui {

struct Settings {
    std::size_t mouse = 0;  ///< Of mouse_presets().
    bool light = false;     ///< The theme.
    double text_size = 1;   ///< Of the whole interface, 1 as the display says; see kTextSizes.
    Keys keys;

    bool operator==(const Settings&) const = default;
};

inline constexpr double kTextSizes[]{0.85, 1, 1.15, 1.3, 1.5, 2};

/// Lines of "name = value", and "key ACTION = Ctrl+S, F5". What is not there, or cannot be read, is as by default.
[[nodiscard]] Settings read_settings(const std::filesystem::path& file);
/// An empty path keeps nothing; what cannot be written is nobody's trouble.
void write_settings(const std::filesystem::path& file, const Settings& settings);

}  // namespace ui
