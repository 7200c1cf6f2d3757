// Where a picture or a mesh is saved, from what was typed.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace ui {

struct SavePath {
    std::filesystem::path path;
    std::string error;  ///< For people, why there is none; else empty.
};

/// "~" and "~/…" begin at the home folder; a name without a suffix gets .png, another suffix than that is refused.
[[nodiscard]] SavePath save_path(std::string_view typed);

/// The same for meshes, drawings and texts: a name without a suffix gets .stl; the suffixes are export_suffixes().
[[nodiscard]] SavePath export_path(std::string_view typed);
[[nodiscard]] std::span<const std::string_view> export_suffixes();

/// "~" and "~/…" with the home folder in their place, other paths as they are.
[[nodiscard]] std::filesystem::path with_home(std::string_view typed);

}  // namespace ui
