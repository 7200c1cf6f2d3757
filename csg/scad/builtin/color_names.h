// The colors of CSS by name and by hexadecimal digits.
#pragma once

#include <optional>
#include <string_view>

#include "csg/tree/tree.h"

namespace csg::scad {

/// A name of CSS in any case, "transparent", or #rgb, #rgba, #rrggbb, #rrggbbaa; nothing for any other text.
[[nodiscard]] std::optional<Rgba> find_color(std::string_view text);

}  // namespace csg::scad
