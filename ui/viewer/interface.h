// Dear ImGui on the window: one context, its fonts and its frames.
#pragma once

#include <vector>

#include "ui/viewer/glfw_window.h"
#include "ui/viewer/input_queue.h"
#include "ui/viewer/settings.h"
#include "ui/viewer/theme.h"

namespace ui {

/// One at a time; the window must outlive it, and its context be current.
class Interface {
  public:
    explicit Interface(const GlfwWindow& window);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// Begins a frame, in which ImGui may be called; follows changes of the display's scale and of the settings.
    /// `input` is the next of the queue.
    void begin(const Input& input, const InputQueue& queue, const Settings& settings);
    /// Ends the frame and draws it over what is in the window's framebuffer.
    void end();

    [[nodiscard]] const Fonts& fonts() const { return fonts_; }
    [[nodiscard]] float scale() const { return scale_; }

  private:
    void set_look(float scale, bool light);
    void press(const Input& input);
    static void point(const Input& input, const InputQueue& queue);

    const GlfwWindow& window_;
    float scale_ = 0;
    bool light_ = false;
    Fonts fonts_;
    std::vector<int> pressed_;  ///< Keys that this frame takes as held.
};

}  // namespace ui
