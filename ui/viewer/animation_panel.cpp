// The bar below the picture that runs $t.
#include <imgui.h>

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "ui/viewer/panel_window.h"
#include "ui/viewer/panels.h"

namespace ui {

void draw_animation(const Rectangle& place, const Animation& animation, Commands& commands) {
    if (place.empty()) {
        return;
    }
    if (begin_panel("Animation", place, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
        const float size = ImGui::GetFontSize();
        if (ImGui::Button(animation.plays() ? "Pause" : "Play", {4 * size, 0})) {
            commands.emplace_back(Action::PlayPause);
        }
        ImGui::SameLine();
        if (ImGui::ArrowButton("back", ImGuiDir_Left)) {
            commands.emplace_back(Action::StepBack);
        }
        ImGui::SameLine(0, 2);
        if (ImGui::ArrowButton("on", ImGuiDir_Right)) {
            commands.emplace_back(Action::StepOn);
        }
        ImGui::SameLine();
        const float others = 21 * size;
        int step = animation.step();
        ImGui::SetNextItemWidth(std::max(place.size.x - ImGui::GetCursorPosX() - others, 3 * size));
        const std::string text = fmt::format("$t = {:.4g}", animation.time());
        if (ImGui::SliderInt("##step", &step, 0, std::max(animation.steps() - 1, 1), text.c_str(),
                             ImGuiSliderFlags_AlwaysClamp)) {
            commands.emplace_back(SetStep{step});
        }
        ImGui::SameLine();
        int steps = animation.steps();
        ImGui::SetNextItemWidth(3.5F * size);
        if (ImGui::InputInt("steps", &steps, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue)) {
            commands.emplace_back(SetSteps{std::clamp(steps, 1, 100'000)});
        }
        ImGui::SameLine();
        auto rate = static_cast<float>(animation.rate());
        ImGui::SetNextItemWidth(3 * size);
        if (ImGui::InputFloat("a second", &rate, 0, 0, "%.4g", ImGuiInputTextFlags_EnterReturnsTrue)) {
            commands.emplace_back(SetRate{std::clamp(static_cast<double>(rate), 0.1, 1000.0)});
        }
        ImGui::SameLine();
        if (ImGui::Button("Export")) {
            commands.emplace_back(ExportFrames{});
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("Writes a picture for each step beside the file: NAME00000.png, …");
        }
    }
    ImGui::End();
}

}  // namespace ui
