// Scales what is selected along its own axes, from its origin.
#pragma once

#include <memory>

namespace ui {

class Tool;

[[nodiscard]] std::unique_ptr<Tool> make_scale_tool();

}  // namespace ui
