// From the texts of options to values. Each throws UsageError, which names the option, where a text is not one.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/camera.h"
#include "ui/command_line/usage_error.h"
#include "ui/pipeline/suggestion.h"
#include "ui/pipeline/trimmed.h"

namespace ui {

/// The numbers of "1,2.5,-3", `counts` of them; the decimal point does not depend on the locale. `meaning` tells what
/// is expected.
[[nodiscard]] std::vector<double> read_numbers(std::string_view option, std::string_view text,
                                               std::initializer_list<std::size_t> counts, std::string_view meaning);
/// The names of "a,b"; none where one of them is empty.
[[nodiscard]] std::vector<std::string> names_of(std::string_view text);
/// Of --imgsize: width and height, whole numbers between the bounds; where `counts` allows one number, it is both.
[[nodiscard]] glm::ivec2 read_size(std::string_view text, std::initializer_list<std::size_t> counts, int least,
                                   int most);
[[nodiscard]] int read_integer(std::string_view option, std::string_view text, int lowest, int highest);
/// As OpenSCAD's --camera takes it: six numbers or seven.
[[nodiscard]] base::Camera read_camera(std::string_view text, bool any_distance = false);

/// The value of that name.
template <typename Value>
[[nodiscard]] Value read_name(std::string_view option, const std::string& text,
                              const std::vector<std::pair<std::string, Value>>& values) {
    std::vector<std::string> names;
    for (const auto& [name, value] : values) {
        if (name == text) {
            return value;
        }
        names.push_back(name);
    }
    throw UsageError(
        fmt::format("{} {}: expected {}.{}", option, text, fmt::join(names, ", "), suggestion(text, names)));
}

}  // namespace ui
