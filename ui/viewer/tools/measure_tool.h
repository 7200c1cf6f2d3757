// Measures what is clicked, a corner, an edge or a face, whichever is nearest to the pointer; and what lies between two
// of them.
#pragma once

#include <memory>

namespace ui {

class Tool;

[[nodiscard]] std::unique_ptr<Tool> make_measure_tool();

}  // namespace ui
