// Turns what is selected about the origin of its own coordinates, as an edit of the text.
#pragma once

#include <memory>

namespace ui {

class Tool;

[[nodiscard]] std::unique_ptr<Tool> make_turn_tool();

}  // namespace ui
