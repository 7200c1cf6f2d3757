// What is said, and typed, while something is dragged.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "ui/viewer/input.h"

namespace ui {

struct ToolPainter;

/// Adds the key to the numbers that are typed, or takes the last one away. False where it is no key for that.
bool type_number(const KeyEvent& event, std::string& typed);

/// Is it one that ends a drag as if the button were released?
[[nodiscard]] bool ends_drag(const KeyEvent& event);

/// Words beside the pointer.
void draw_drag_text(const std::string& words, const glm::dvec2& pointer, const ToolPainter& painter);

}  // namespace ui
