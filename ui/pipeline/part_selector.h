// Which parts a person means: part=NAME, color=COLOR, module=NAME.
#pragma once

#include <string>
#include <string_view>

#include "npr/part_style.h"

namespace ui {

/// Throws std::runtime_error, which begins with `text`, where it is none of these.
[[nodiscard]] npr::PartSelector read_selector(const std::string& text, std::string_view what);
/// The same, but NAME alone is part=NAME.
[[nodiscard]] npr::PartSelector read_part_selector(const std::string& text, std::string_view what);

}  // namespace ui
