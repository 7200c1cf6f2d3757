#include "ui/viewer/save_path.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace ui {

std::filesystem::path with_home(std::string_view typed) {
    const char* const home = std::getenv("HOME");
    if (home != nullptr && *home != '\0' && (typed == "~" || typed.starts_with("~/"))) {
        return std::filesystem::path(home) / typed.substr(std::min<std::size_t>(2, typed.size()));
    }
    return typed;
}

SavePath save_path(std::string_view typed) {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
    while (!typed.empty() && is_blank(typed.front())) {
        typed.remove_prefix(1);
    }
    while (!typed.empty() && is_blank(typed.back())) {
        typed.remove_suffix(1);
    }
    std::filesystem::path path = with_home(typed);
    if (typed.empty() || !path.has_filename() || typed == "~") {
        return {{}, "The picture needs a name."};
    }
    std::string suffix = path.extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (suffix.empty()) {
        path += ".png";
    } else if (suffix != ".png") {
        return {{}, "Pictures are saved as PNG: " + path.replace_extension(".png").filename().string()};
    }
    return {path, ""};
}

}  // namespace ui
