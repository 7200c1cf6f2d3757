#include "ui/viewer/save_path.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <string>

namespace ui {

std::filesystem::path with_home(std::string_view typed) {
    const char* const home = std::getenv("HOME");
    if (home != nullptr && *home != '\0' && (typed == "~" || typed.starts_with("~/"))) {
        return std::filesystem::path(home) / typed.substr(std::min<std::size_t>(2, typed.size()));
    }
    return typed;
}

namespace {

/// `what`: "The picture". `suffixes`: those that may be, the first where there is none; `refusal`: of others.
SavePath path_of(std::string_view typed, const char* what, std::span<const std::string_view> suffixes,
                 const std::string& refusal) {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
    while (!typed.empty() && is_blank(typed.front())) {
        typed.remove_prefix(1);
    }
    while (!typed.empty() && is_blank(typed.back())) {
        typed.remove_suffix(1);
    }
    std::filesystem::path path = with_home(typed);
    if (typed.empty() || !path.has_filename() || typed == "~") {
        return {{}, std::string(what) + " needs a name."};
    }
    std::string suffix = path.extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (suffix.empty()) {
        path += suffixes.front();
    } else if (std::find(suffixes.begin(), suffixes.end(), suffix) == suffixes.end()) {
        return {{}, refusal + path.replace_extension(suffixes.front()).filename().string()};
    }
    return {path, ""};
}

}  // namespace

SavePath save_path(std::string_view typed) {
    static constexpr std::array<std::string_view, 1> kSuffixes{".png"};
    return path_of(typed, "The picture", kSuffixes, "Pictures are saved as PNG: ");
}

std::span<const std::string_view> export_suffixes() {
    static constexpr std::array<std::string_view, 11> kSuffixes{".stl", ".3mf", ".off", ".obj", ".amf", ".wrl",
                                                                ".pov", ".svg", ".dxf", ".pdf", ".csg"};
    return kSuffixes;
}

SavePath export_path(std::string_view typed) {
    return path_of(typed, "The file", export_suffixes(), "There is no such format. A mesh is, for example, ");
}

}  // namespace ui
