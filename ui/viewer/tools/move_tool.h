// Moves what is selected by handles; the text follows.
#pragma once

#include <memory>

namespace ui {

class Tool;

[[nodiscard]] std::unique_ptr<Tool> make_move_tool();

}  // namespace ui
