// A window of the desktop with an OpenGL 4.5 core context, through GLFW.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "ui/viewer/input.h"

struct GLFWwindow;

namespace ui {

/// One at a time, on the main thread. The context is current from the beginning.
class GlfwWindow {
  public:
    /// `size` in units of a common display; grows with the display's content scale. Throws std::runtime_error with the
    /// reason where there is no display or no such OpenGL.
    GlfwWindow(const std::string& title, glm::ivec2 size);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    [[nodiscard]] GLFWwindow* handle() const { return window_; }
    [[nodiscard]] glm::ivec2 size() const;              ///< Units of the window, those of the pointer.
    [[nodiscard]] glm::ivec2 framebuffer_size() const;  ///< Pixels; 0 while minimized.
    /// How much larger than on a common display text should be, in units of the window.
    [[nodiscard]] float interface_scale() const;
    /// Somebody wants it to be closed, since this was asked last.
    [[nodiscard]] bool take_close_request() const;

    /// Waits for input, a wake-up, or at most `seconds` (0: only looks), and takes the input.
    [[nodiscard]] Input wait(double seconds);
    /// Ends a wait, from any thread.
    static void wake();

    void make_current() const;
    void swap() const;
    void hide() const;
    void set_title(const std::string& title) const;
    void set_clipboard(const std::string& text) const;

  private:
    void install_callbacks();

    GLFWwindow* window_ = nullptr;
    Input input_;
};

/// Finds OpenGL functions of the current context.
[[nodiscard]] void* window_symbol(const char* name);

}  // namespace ui
