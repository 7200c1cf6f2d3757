// Paths as texts. (What std::filesystem takes for its paths is felt where a program names hundreds of files.)
#pragma once

#include <string>
#include <string_view>

namespace csg::scad {

/// Without ".", "a/.." and double slashes, as std::filesystem's lexically_normal makes it.
[[nodiscard]] std::string normal_path(std::string_view path);

/// `name` in `folder`; `name` itself where it is absolute or the folder is "". Not normalized.
[[nodiscard]] std::string path_in(std::string_view folder, std::string_view name);

/// Up to the last slash, without it; "" where there is none, "/" for a file in the root.
[[nodiscard]] std::string_view folder_of_path(std::string_view path);

}  // namespace csg::scad
