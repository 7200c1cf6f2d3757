// Hands out input frame by frame, so that nothing of it is lost that the interface can see only once a frame.
#pragma once

#include <deque>

#include "ui/viewer/input.h"

namespace ui {

/// The interface (ImGui 1.86) looks at what is held, and where the pointer is, when a frame begins. A click that begins
/// and ends within a frame, or a drag that ends elsewhere, would go unseen: so what comes after a change of a button
/// waits for the next frame, as the end of a drag does, and a second press of a key.
class InputQueue {
  public:
    void add(Input input);

    /// What the next frame is to see, in the order in which it happened; its cursor is where the pointer is then.
    [[nodiscard]] Input next();

    /// Nothing waits.
    [[nodiscard]] bool empty() const { return pointer_.empty() && keys_.empty() && !any_; }
    /// As of the last frame.
    [[nodiscard]] bool held(Button button) const { return held_[static_cast<int>(button)]; }
    [[nodiscard]] bool any_held() const { return held_[1] || held_[2] || held_[3]; }

  private:
    std::deque<PointerEvent> pointer_;
    std::deque<KeyEvent> keys_;
    std::vector<std::string> dropped_;
    glm::dvec2 cursor_{0}, latest_{0};  ///< As of the last frame; as it is by now.
    bool held_[4]{};                    ///< By Button.
    bool any_ = false;
};

}  // namespace ui
