// How something is drawn, as people write it: STYLE,PARAMETER=VALUE,…
#pragma once

#include <string_view>

#include "npr/part_style.h"

namespace ui {

/// A PartStyle of no part yet. Throws std::runtime_error where there is no such style, parameter or value; names the
/// nearest one.
[[nodiscard]] npr::PartStyle read_drawn_style(std::string_view text);

}  // namespace ui
