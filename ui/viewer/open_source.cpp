#include "ui/viewer/open_source.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <system_error>
#include <tuple>

#include "csg/scad/value/quoted.h"

namespace ui {

namespace {

constexpr std::array<std::string_view, 2> kPrograms{".scad", ".csg"};
constexpr std::array<std::string_view, 7> kImports{".stl", ".off", ".obj", ".amf", ".3mf", ".svg", ".dxf"};

std::string suffix_of(const std::filesystem::path& path) {
    std::string suffix = path.extension().string();
    std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return suffix;
}

bool is_import(const std::filesystem::path& path) {
    return std::ranges::find(kImports, suffix_of(path)) != kImports.end();
}

}  // namespace

bool can_open(const std::filesystem::path& path) {
    return is_import(path) || std::ranges::find(kPrograms, suffix_of(path)) != kPrograms.end();
}

Source opened(const std::filesystem::path& path, const Source& before) {
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(path, error);
    Source source;
    source.path = (error ? path : absolute.lexically_normal()).string();
    if (is_import(path)) {
        source.text = "import(" + csg::scad::quoted(source.path) + ");\n";
    }
    source.preview = before.preview;
    source.hard_warnings = before.hard_warnings;
    source.by_error = before.by_error;
    source.lazy_union = before.lazy_union;
    source.parts = before.parts;
    return source;
}

std::vector<FolderEntry> entries_of(const std::filesystem::path& folder) {
    constexpr std::size_t kMost = 10'000;
    std::vector<FolderEntry> entries;
    std::error_code error;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        std::error_code unknown;
        const bool is_folder = at->is_directory(unknown);
        if (!name.starts_with('.') && (is_folder || can_open(at->path())) && entries.size() < kMost) {
            entries.push_back({name, is_folder});
        }
    }
    std::ranges::sort(entries, {}, [](const FolderEntry& entry) { return std::tuple(!entry.folder, entry.name); });
    return entries;
}

}  // namespace ui
