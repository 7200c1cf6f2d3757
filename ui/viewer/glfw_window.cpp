#include "ui/viewer/glfw_window.h"

#include <GLFW/glfw3.h>

#include <cctype>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "base/decode_png.h"
#include "ui/viewer/icon_bytes.h"

namespace ui {

namespace {

constexpr int kModifiers = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT | GLFW_MOD_SUPER;  // Not the locks.

[[noreturn]] void fail() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    const std::string text = reason != nullptr ? reason : "unknown reason";
    glfwTerminate();
    throw std::runtime_error(fmt::format("no window can be opened ({}); write a picture with -o picture.png", text));
}

Input& input_of(GLFWwindow* window) {
    Input& input = *static_cast<Input*>(glfwGetWindowUserPointer(window));
    input.any = true;
    return input;
}

void note_other(GLFWwindow* window) {
    input_of(window).other = true;
}

PointerEvent pointer_event(GLFWwindow* window, PointerKind kind) {
    PointerEvent event;
    event.kind = kind;
    // Not where the pointer is by now, as glfwGetCursorPos has it: it may have gone on since.
    event.position = input_of(window).cursor;
    event.time = glfwGetTime();
    return event;
}

Button button_of(int button) {
    switch (button) {
        case GLFW_MOUSE_BUTTON_LEFT:
            return Button::Left;
        case GLFW_MOUSE_BUTTON_RIGHT:
            return Button::Right;
        case GLFW_MOUSE_BUTTON_MIDDLE:
            return Button::Middle;
        default:
            return Button::None;
    }
}

/// GLFW counts keys by their place on an American keyboard; letters are taken as they are printed on this one.
int printed_key(int key, int scancode) {
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) {
        const char* name = glfwGetKeyName(key, scancode);
        if (name != nullptr && name[1] == '\0' && std::isalpha(static_cast<unsigned char>(name[0])) != 0) {
            return std::toupper(static_cast<unsigned char>(name[0]));
        }
    }
    return key;
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    Input& input = input_of(window);
    if (action != GLFW_RELEASE) {
        input.keys.push_back({{printed_key(key, scancode), modifiers & kModifiers}, key});
    }
}

void on_button(GLFWwindow* window, int button, int action, int modifiers) {
    PointerEvent event = pointer_event(window, action == GLFW_PRESS ? PointerKind::Press : PointerKind::Release);
    event.button = button_of(button);
    event.modifiers = modifiers & kModifiers;
    Input& input = input_of(window);
    if (event.button != Button::None) {
        input.pointer.push_back(event);
    }
}

void on_cursor(GLFWwindow* window, double x, double y) {
    PointerEvent event = pointer_event(window, PointerKind::Move);
    event.position = {x, y};
    Input& input = input_of(window);
    input.cursor = event.position;
    input.pointer.push_back(event);
}

void on_scroll(GLFWwindow* window, double /*x*/, double y) {
    PointerEvent event = pointer_event(window, PointerKind::Scroll);
    event.amount = y;
    input_of(window).pointer.push_back(event);
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
    Input& input = input_of(window);
    input.dropped.insert(input.dropped.end(), paths, paths + count);
    note_other(window);
}

}  // namespace

GlfwWindow::GlfwWindow(const std::string& title, glm::ivec2 size) {
    if (glfwInit() != GLFW_TRUE) {
        fail();
    }
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    // Depth and samples are the pictures' own affair.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_ALPHA_BITS, 0);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "csgscope");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "csgscope");
    window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
        fail();
    }
    base::Image icon = base::decode_png(icon_bytes(), "icon");
    const GLFWimage pixels{icon.width, icon.height, icon.rgba.data()};
    glfwSetWindowIcon(window_, 1, &pixels);
    glfwSetWindowSizeLimits(window_, 320, 240, GLFW_DONT_CARE, GLFW_DONT_CARE);
    make_current();
    glfwSwapInterval(1);
    install_callbacks();
}

GlfwWindow::~GlfwWindow() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void GlfwWindow::install_callbacks() {
    input_.any = input_.other = true;  // Nothing is drawn yet.
    glfwGetCursorPos(window_, &input_.cursor.x, &input_.cursor.y);
    glfwSetWindowUserPointer(window_, &input_);
    glfwSetKeyCallback(window_, on_key);
    glfwSetMouseButtonCallback(window_, on_button);
    glfwSetCursorPosCallback(window_, on_cursor);
    glfwSetScrollCallback(window_, on_scroll);
    glfwSetDropCallback(window_, on_drop);
    glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned) { note_other(window); });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int) { note_other(window); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int) { note_other(window); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { note_other(window); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { note_other(window); });
    glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* window, float, float) { note_other(window); });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) { note_other(window); });
}

glm::ivec2 GlfwWindow::size() const {
    glm::ivec2 size{0};
    glfwGetWindowSize(window_, &size.x, &size.y);
    return size;
}

glm::ivec2 GlfwWindow::framebuffer_size() const {
    glm::ivec2 size{0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

float GlfwWindow::interface_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    // Where units of the window are larger than pixels, they have part of the scale in them.
    const float pixels_per_unit =
        size().x > 0 ? static_cast<float>(framebuffer_size().x) / static_cast<float>(size().x) : 1.0F;
    const float scale = x / (pixels_per_unit > 0 ? pixels_per_unit : 1.0F);
    return scale >= 0.5F && scale <= 8 ? scale : 1.0F;
}

bool GlfwWindow::take_close_request() const {
    const bool requested = glfwWindowShouldClose(window_) == GLFW_TRUE;
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
    return requested;
}

Input GlfwWindow::wait(double seconds) {
    if (seconds > 0 && !input_.any) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
    Input next;
    next.cursor = input_.cursor;
    return std::exchange(input_, next);
}

void GlfwWindow::wake() {
    glfwPostEmptyEvent();
}
void GlfwWindow::make_current() const {
    glfwMakeContextCurrent(window_);
}
void GlfwWindow::swap() const {
    glfwSwapBuffers(window_);
}
void GlfwWindow::hide() const {
    glfwHideWindow(window_);
}
void GlfwWindow::set_title(const std::string& title) const {
    glfwSetWindowTitle(window_, title.c_str());
}
void GlfwWindow::set_clipboard(const std::string& text) const {
    glfwSetClipboardString(window_, text.c_str());
}

void* window_symbol(const char* name) {
    return reinterpret_cast<void*>(glfwGetProcAddress(name));
}

}  // namespace ui
