// Changes the dimensions of the shape that is selected, which are numbers of its call.
#pragma once

#include <memory>

namespace ui {

class Tool;

[[nodiscard]] std::unique_ptr<Tool> make_size_tool();

}  // namespace ui
