// From the mouse to the camera: dragging turns and shifts, the wheel comes nearer, a double click chooses the center.
#pragma once

#include <optional>

#include "base/camera.h"
#include "ui/viewer/input.h"
#include "ui/viewer/layout.h"
#include "ui/viewer/mouse_preset.h"

namespace ui {

class Navigator {
  public:
    /// Of mouse_presets().
    void set_preset(std::size_t preset) { preset_ = preset; }

    /// Applies the event to the camera of the picture that lies in `picture`. `free`: no part of the interface lies
    /// over the picture there. A drag that began in the picture goes on outside of it.
    void handle(const PointerEvent& event, const Rectangle& picture, bool free, base::Camera& camera);

    /// A drag goes on.
    [[nodiscard]] bool dragging() const { return button_ != Button::None; }
    /// Where the picture was double-clicked since the last call, from the picture's upper left corner.
    [[nodiscard]] std::optional<glm::dvec2> take_double_click();

    /// Where the surface under the pointer is to be found, since the last call, from the picture's upper left corner:
    /// turns and zooms go about it.
    [[nodiscard]] std::optional<glm::dvec2> take_question();
    /// The answer, whenever it comes; none where there is no surface, and turns go about the camera's target.
    void answer(const std::optional<glm::dvec3>& surface) { pivot_ = surface; }

    /// Where the picture was clicked, without being dragged, since the last call.
    [[nodiscard]] std::optional<glm::dvec2> take_click();

  private:
    void ask(const PointerEvent& event, const Rectangle& picture);
    void press(const PointerEvent& event, const Rectangle& picture);
    void release(const PointerEvent& event, const Rectangle& picture);
    void drag(const glm::dvec2& way, int height, base::Camera& camera) const;

    std::size_t preset_ = 0;
    Button button_ = Button::None;
    Button before_ = Button::None;  ///< Held when that was pressed: its drag goes on afterwards.
    int modifiers_ = 0;             ///< Held when it was.
    DragMotion motion_ = DragMotion::None;
    glm::dvec2 last_{0};
    double clicked_at_ = -1;
    glm::dvec2 clicked_{0};
    bool dragged_ = false;  ///< Since the button was pressed.
    std::optional<glm::dvec2> double_click_, click_;
    std::optional<glm::dvec2> question_, asked_;  ///< To be taken; that was asked last.
    std::optional<glm::dvec3> pivot_;             ///< World coordinates, of the surface at asked_.
};

}  // namespace ui
