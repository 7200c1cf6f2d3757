#include <imgui.h>

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "ui/viewer/panels.h"

namespace ui {

namespace {

bool draw_choice(const char* id, const npr::Parameter& parameter, int& chosen) {
    bool changed = false;
    const std::string shown(parameter.choices[static_cast<std::size_t>(chosen)]);
    if (ImGui::BeginCombo(id, shown.c_str())) {
        for (int i = 0; i < static_cast<int>(parameter.choices.size()); ++i) {
            const std::string label(parameter.choices[static_cast<std::size_t>(i)]);
            if (ImGui::Selectable(label.c_str(), i == chosen) && i != chosen) {
                chosen = i;
                changed = true;
            }
        }
        ImGui::EndCombo();
    }
    return changed;
}

}  // namespace

bool draw_parameter(const npr::Parameter& parameter, npr::Value& value) {
    const std::string label(parameter.label);
    const std::string id = fmt::format("##{}", parameter.name);
    if (parameter.kind == npr::ParameterKind::Toggle) {
        return ImGui::Checkbox((label + id).c_str(), &std::get<bool>(value));
    }
    if (parameter.kind == npr::ParameterKind::Color) {
        glm::vec3& color = std::get<glm::vec3>(value);
        const bool changed = ImGui::ColorEdit3((label + id).c_str(), &color.x, ImGuiColorEditFlags_NoInputs);
        color = glm::clamp(color, 0.0F, 1.0F);
        return changed;
    }
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label.c_str());
    if (ImGui::CalcTextSize(label.c_str()).x < 0.7F * width) {
        ImGui::SameLine(ImGui::GetCursorPosX() + std::max(0.62F * width, ImGui::CalcTextSize(label.c_str()).x + 6));
    }
    ImGui::SetNextItemWidth(-1);
    switch (parameter.kind) {
        case npr::ParameterKind::Number: {
            const char* format = parameter.max - parameter.min > 20 ? "%.0f" : "%.2f";
            return ImGui::SliderFloat(id.c_str(), &std::get<float>(value), parameter.min, parameter.max, format,
                                      ImGuiSliderFlags_AlwaysClamp);
        }
        case npr::ParameterKind::Integer:
            return ImGui::SliderInt(id.c_str(), &std::get<int>(value), static_cast<int>(parameter.min),
                                    static_cast<int>(parameter.max), "%d", ImGuiSliderFlags_AlwaysClamp);
        case npr::ParameterKind::Choice:
            return draw_choice(id.c_str(), parameter, std::get<int>(value));
        case npr::ParameterKind::Toggle:
        case npr::ParameterKind::Color:
            break;
    }
    return false;
}

}  // namespace ui
