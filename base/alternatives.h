// Names as a sentence lists them.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace base {

/// "a, b or c"
[[nodiscard]] inline std::string alternatives(std::span<const std::string> names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        text += i == 0 ? "" : i + 1 < names.size() ? ", " : " or ";
        text += names[i];
    }
    return text;
}

}  // namespace base
