#include "ui/viewer/inspection_panel.h"

#include <imgui.h>

#include <fmt/format.h>

#include "ui/viewer/panel_window.h"

namespace ui {

void PartChoice::draw(const char* automatic) {
    const std::array<const char*, 4> choices{automatic, "The whole model", "What the top-level union joins",
                                             "What has one color"};
    ImGui::SetNextItemWidth(-1);
    ImGui::Combo("##parts", &chosen, choices.data(), static_cast<int>(choices.size()));
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("What a part is");
    }
}

csg::PartRule PartChoice::rule(const csg::PartRule& automatic) const {
    using Kind = csg::PartRule::Kind;
    switch (chosen) {
        case 1:
            return {Kind::Model, 1, {}};
        case 2:
            return {Kind::Depth, 1, {}};
        case 3:
            return {Kind::Color, 1, {}};
        default:
            return automatic;
    }
}

bool task_button(const char* label, const char* task, const Inspection& inspection, Commands& commands) {
    const bool runs = inspection.task() == task;
    const std::string text = runs ? fmt::format("Cancel ({} s)", inspection.task_seconds()) : label;
    if (!ImGui::Button((text + "##task").c_str(), {-1, 0})) {
        return false;
    }
    if (runs) {
        ask(commands, CancelInspection{});
    }
    return !runs;
}

void tell_state(const InspectionAnswer& answer, const Session& session) {
    error_text(answer.error);
    const auto& model = session.document().model();
    if (answer.error.empty() && model && model->generation != answer.asked_of) {
        ImGui::TextDisabled("of the model as it was before");
    }
}

void InspectionPanel::draw(const Rectangle& place, const InspectionView& view, Commands& commands) {
    if (place.empty()) {
        return;
    }
    const bool open = begin_panel("Inspection", place);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2, ImGui::GetStyle().FramePadding.y});
    const bool tabs = open && ImGui::BeginTabBar("views");
    ImGui::PopStyleVar();
    if (tabs) {
        const auto tab = [&](const char* name, auto& drawn) {
            if (ImGui::BeginTabItem(name)) {
                drawn.draw(view, commands);
                ImGui::EndTabItem();
            }
        };
        tab("Thickness", thickness_);
        tab("Checks", checks_);
        tab("Measures", measures_);
        tab("Changes", changes_);
        ImGui::EndTabBar();
    }
    ImGui::End();
}

}  // namespace ui
