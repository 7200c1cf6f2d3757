// A cube in the upper right corner of the picture that turns with the model: a click on a face, an edge or a corner
// looks from there, a drag turns.
#pragma once

#include <memory>

namespace ui {

class Tool;

[[nodiscard]] std::unique_ptr<Tool> make_view_cube();

}  // namespace ui
