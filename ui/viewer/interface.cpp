#include "ui/viewer/interface.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <stdexcept>
#include <utility>

namespace ui {

Interface::Interface(const GlfwWindow& window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // The places of the panels follow from the window's size.
    ImGui::GetIO().LogFilename = nullptr;
    if (!ImGui_ImplGlfw_InitForOpenGL(window.handle(), true) || !ImGui_ImplOpenGL3_Init("#version 450 core")) {
        throw std::runtime_error("the interface cannot be drawn with this OpenGL");
    }
}

Interface::~Interface() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Interface::set_look(float scale, bool light) {
    if (scale == scale_ && light == light_) {
        return;
    }
    apply_theme(scale, light);
    light_ = light;
    if (scale == scale_) {
        return;
    }
    scale_ = scale;
    fonts_ = load_fonts(scale);
    ImGui_ImplOpenGL3_DestroyDeviceObjects();  // The texture of the fonts too; made anew with the next frame.
}

void Interface::press(const Input& input) {
    // ImGui 1.86 looks at which keys are held when a frame begins. A key that was pressed and released since the last
    // one would go unseen, so it is held for this frame, with the modifiers that it came with.
    ImGuiIO& io = ImGui::GetIO();
    for (const int key : std::exchange(pressed_, {})) {
        if (glfwGetKey(window_.handle(), key) == GLFW_RELEASE) {
            io.KeysDown[key] = false;
        }
    }
    const auto held = [&](int left, int right) {
        return glfwGetKey(window_.handle(), left) == GLFW_PRESS || glfwGetKey(window_.handle(), right) == GLFW_PRESS;
    };
    io.KeyCtrl = held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    for (const KeyEvent& event : input.keys) {
        if (event.key >= 0 && event.key < IM_ARRAYSIZE(io.KeysDown)) {
            io.KeysDown[event.key] = true;
            pressed_.push_back(event.key);
        }
        io.KeyCtrl |= (event.chord.modifiers & GLFW_MOD_CONTROL) != 0;
        io.KeyShift |= (event.chord.modifiers & GLFW_MOD_SHIFT) != 0;
    }
}

void Interface::point(const Input& input, const InputQueue& queue) {
    // In place of what GLFW says of this moment, what the queue says of this frame.
    ImGuiIO& io = ImGui::GetIO();
    if (!input.pointer.empty() || !queue.empty()) {
        io.MousePos = {static_cast<float>(input.cursor.x), static_cast<float>(input.cursor.y)};
    }
    io.MouseDown[ImGuiMouseButton_Left] = queue.held(Button::Left);
    io.MouseDown[ImGuiMouseButton_Right] = queue.held(Button::Right);
    io.MouseDown[ImGuiMouseButton_Middle] = queue.held(Button::Middle);
}

void Interface::begin(const Input& input, const InputQueue& queue, const Settings& settings) {
    set_look(window_.interface_scale() * static_cast<float>(settings.text_size), settings.light);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    press(input);
    point(input, queue);
    ImGui::NewFrame();
}

void Interface::end() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace ui
