// csgscope move: a solid moved, as an edit of the text.
#pragma once

#include <string>
#include <vector>

namespace ui {

/// The arguments behind "move". 0, or 1 where nothing can be moved as asked; a message says why.
[[nodiscard]] int run_move(const std::vector<std::string>& arguments);

}  // namespace ui
