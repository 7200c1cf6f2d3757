// The handle of a plane that cuts the model: an arrow in the middle of the cut, dragged along the plane's normal.
#pragma once

#include <memory>

namespace ui {

class Tool;

[[nodiscard]] std::unique_ptr<Tool> make_section_tool();

}  // namespace ui
