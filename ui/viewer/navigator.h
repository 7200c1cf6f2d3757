// From the mouse to the camera: dragging turns and shifts, the wheel comes nearer, a double click chooses the center.
#pragma once

#include <optional>

#include "base/camera.h"
#include "ui/viewer/input.h"
#include "ui/viewer/layout.h"

namespace ui {

class Navigator {
  public:
    /// Applies the event to the camera of the picture that lies in `picture`. `free`: no part of the interface lies
    /// over the picture there. A drag that began in the picture goes on outside of it.
    void handle(const PointerEvent& event, const Rectangle& picture, bool free, base::Camera& camera);

    /// A drag goes on.
    [[nodiscard]] bool dragging() const { return button_ != Button::None; }
    /// Where the picture was double-clicked since the last call, from the picture's upper left corner.
    [[nodiscard]] std::optional<glm::dvec2> take_double_click();

    /// Where the picture was clicked, without being dragged, since the last call.
    [[nodiscard]] std::optional<glm::dvec2> take_click();

  private:
    void press(const PointerEvent& event, const Rectangle& picture);

    Button button_ = Button::None;
    bool pans_ = false;
    glm::dvec2 last_{0};
    double clicked_at_ = -1;
    glm::dvec2 clicked_{0};
    bool dragged_ = false;  ///< Since the button was pressed.
    std::optional<glm::dvec2> double_click_, click_;
};

}  // namespace ui
