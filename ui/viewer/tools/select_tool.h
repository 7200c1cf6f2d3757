// Selects what is clicked: first the nearest surface, then those behind it.
#pragma once

#include <memory>

namespace ui {

class Tool;

[[nodiscard]] std::unique_ptr<Tool> make_select_tool();

}  // namespace ui
