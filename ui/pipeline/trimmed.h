// Texts that people write, without the blanks about them.
#pragma once

#include <string_view>

namespace ui {

/// Without blanks at its ends.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace ui
