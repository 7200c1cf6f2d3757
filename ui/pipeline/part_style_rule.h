// What is a part where parts have styles of their own (--style-of).
#pragma once

#include <span>
#include <string>

#include "csg/tree/part_rule.h"

namespace ui {

/// What is to be a part where nothing else says it: the modules that are named, else what has one color where a color
/// is, else the children of the top-level union. `texts`: as read_part_style and read_revealed_part
/// (ui/command_line/part_style_options.h) and labels take them.
[[nodiscard]] csg::PartRule parts_of_styles(std::span<const std::string> texts);

}  // namespace ui
