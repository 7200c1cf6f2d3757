#pragma once

#include <string_view>

namespace ui {

/// The program's icon, share/csgscope.png: the bytes of that file.
[[nodiscard]] std::string_view icon_bytes();

}  // namespace ui
