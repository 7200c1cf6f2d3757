// Where the parts of the window are. The picture gets what the others leave, so that nothing hides the model.
#pragma once

#include <glm/glm.hpp>

#include "ui/pipeline/picture/view_marks.h"

namespace ui {

/// In units of the window, from its upper left corner, y down.
struct Rectangle {
    glm::vec2 corner{0};
    glm::vec2 size{0};

    [[nodiscard]] bool contains(const glm::dvec2& point) const {
        const glm::dvec2 from_corner = point - glm::dvec2(corner);
        return from_corner.x >= 0 && from_corner.y >= 0 && from_corner.x < size.x && from_corner.y < size.y;
    }
    [[nodiscard]] bool empty() const { return size.x < 1 || size.y < 1; }
};

/// What is open.
struct Shown {
    bool panel = true;
    bool inspection = false, dynamics = false;            ///< In the panel's place; one of them at most.
    bool customizer = false, text = false, tree = false;  ///< One of them at most.
    bool animation = false;
    bool console = true;
    bool axes = true;
    bool cube = true;
    bool scales = false, grid = false;  ///< In the scene: the axes with their scales; lines on the ground.
    bool help = false;
    bool save_form = false;
    bool open_form = false;
    bool export_form = false;
    bool settings_form = false;
    bool palette = false;
    bool leave_form = false;     ///< Asks what is to become of what is not saved.
    bool recovery_form = false;  ///< Offers what a killed program has left.
    bool hole = false;           ///< What is added is taken away from what is selected.

    /// Something lies over the picture.
    [[nodiscard]] bool covered() const {
        return help || save_form || open_form || export_form || settings_form || palette || leave_form || recovery_form;
    }
    [[nodiscard]] ViewMarks marks() const { return {scales, scales, false, false, grid}; }
    void uncover() {
        help = save_form = open_form = export_form = settings_form = palette = leave_form = recovery_form = false;
    }
};

struct Layout {
    Rectangle picture, panel, left, console, status, animation;  ///< Empty where not shown. `left`: see Shown.
};

/// Lays out a window of the given size below its menu bar. `scale`: of the interface, 1 for a common display.
/// `console_height` is what the user wants; it is kept within limits. In small windows panels and console are folded.
/// Rectangles begin and end at whole units.
[[nodiscard]] Layout make_layout(glm::vec2 window, float menu_height, float scale, const Shown& shown,
                                 float console_height);

}  // namespace ui
