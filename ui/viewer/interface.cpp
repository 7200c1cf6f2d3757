#include "ui/viewer/interface.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <stdexcept>

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

void Interface::set_scale(float scale) {
    if (scale == scale_) {
        return;
    }
    scale_ = scale;
    apply_theme(scale);
    fonts_ = load_fonts(scale);
    ImGui_ImplOpenGL3_DestroyFontsTexture();  // Made anew with the next frame.
    ImGui_ImplOpenGL3_DestroyDeviceObjects();
}

void Interface::begin() {
    set_scale(window_.interface_scale());
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Interface::end() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace ui
