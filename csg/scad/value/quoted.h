// Texts as the language writes them.
#pragma once

#include <string>
#include <string_view>

namespace csg::scad {

/// With quotes, and escapes where the language needs them.
[[nodiscard]] std::string quoted(std::string_view text);

}  // namespace csg::scad
