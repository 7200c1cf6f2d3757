// Flies through the model, and into its solids: the eye moves, and turns where it is.
#pragma once

#include <memory>

namespace ui {

class Tool;

[[nodiscard]] std::unique_ptr<Tool> make_fly_tool();

}  // namespace ui
