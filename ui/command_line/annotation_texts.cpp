#include "ui/command_line/annotation_texts.h"

#include <fmt/format.h>

#include "ui/command_line/usage_error.h"

namespace ui {

std::pair<std::string, std::string> split_label(const std::string& text) {
    std::size_t begin = 0;
    for (const char* const word : {"part=", "color=", "module="}) {
        if (text.starts_with(word)) {
            begin = std::string(word).size();
        }
    }
    const std::size_t equals = text.find('=', begin);
    if (equals == std::string::npos || equals == begin || equals + 1 == text.size()) {
        throw UsageError(fmt::format("--label {}: expected PART=TEXT", text));
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace ui
