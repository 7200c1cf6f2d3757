#include "ui/viewer/customizer_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ui/viewer/panel_window.h"

namespace ui {

namespace {

using Parameter = csg::scad::CustomizerParameter;

/// In the order in which the text names them.
std::vector<std::string> groups_of(const Customizer& customizer) {
    std::vector<std::string> groups;
    for (const Parameter& parameter : customizer.parameters()) {
        if (std::ranges::find(groups, parameter.group) == groups.end()) {
            groups.push_back(parameter.group);
        }
    }
    return groups;
}

/// As OpenSCAD shows it.
std::string label_of(const Parameter& parameter) {
    std::string label = parameter.name;
    std::ranges::replace(label, '_', ' ');
    return label;
}

void draw_row(const Customizer& customizer, const Parameter& parameter, Commands& commands) {
    const bool changed = customizer.changed(parameter);
    ImGui::PushID(parameter.name.c_str());
    if (!parameter.caption.empty()) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled("%s", parameter.caption.c_str());
        ImGui::PopTextWrapPos();
    }
    const float width = ImGui::GetContentRegionAvail().x;
    const std::string label = label_of(parameter);
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(changed ? theme::accent() : theme::text(), "%s", label.c_str());
    const bool wide = std::holds_alternative<std::vector<double>>(parameter.initial);
    if (!wide && ImGui::CalcTextSize(label.c_str()).x < 0.42F * width) {
        ImGui::SameLine(0.45F * width);
    }
    // Room for the button is kept also where it is not shown: a slider that is dragged must stay as it is.
    ImGui::SetNextItemWidth(-ImGui::GetFrameHeight() - ImGui::GetStyle().ItemInnerSpacing.x);
    Parameter::Value value = customizer.value(parameter);
    if (draw_customized(parameter, value)) {
        commands.emplace_back(SetCustomized{parameter.name, std::move(value)});
    }
    if (changed) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFrameHeight());
        if (ImGui::ArrowButton("##reset", ImGuiDir_Left)) {
            commands.emplace_back(ResetCustomized{parameter.name});
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("Back to %s, as the text says", csg::scad::expression_of(parameter.initial).c_str());
        }
    }
    ImGui::PopID();
}

}  // namespace

void CustomizerPanel::sets(const Customizer& customizer, Commands& commands) {
    if (customizer.file().empty()) {
        return;  // What came from standard input has no place beside it.
    }
    if (shown_ != customizer.used()) {
        shown_ = name_ = customizer.used();
    }
    ImGui::SetNextItemWidth(-1);
    const char* const as_text = "as the text says";
    if (ImGui::BeginCombo("##sets", shown_.empty() ? as_text : shown_.c_str())) {
        if (ImGui::Selectable(as_text, shown_.empty())) {
            commands.emplace_back(ResetCustomized{});
        }
        for (const ParameterSet& set : customizer.sets()) {
            ImGui::PushID(&set);
            if (ImGui::Selectable(set.name.c_str(), set.name == shown_)) {
                commands.emplace_back(UseParameterSet{set.name});
            }
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    const ImGuiStyle& style = ImGui::GetStyle();
    const bool there = std::ranges::find(customizer.sets(), name_, &ParameterSet::name) != customizer.sets().end();
    const auto width = [&](const char* text) { return ImGui::CalcTextSize(text).x + 2 * style.FramePadding.x; };
    ImGui::SetNextItemWidth(-width("Replace") - width("Delete?") - 2 * style.ItemInnerSpacing.x);
    sure_ = !ImGui::InputTextWithHint("##name", "name of a set", &name_) && sure_;
    ImGui::SameLine(0, style.ItemInnerSpacing.x);
    ImGui::BeginDisabled(name_.empty());
    if (ImGui::Button(there ? "Replace" : "Save", {width("Replace"), 0})) {
        commands.emplace_back(SaveParameterSet{name_});
    }
    ImGui::EndDisabled();
    ImGui::SameLine(0, style.ItemInnerSpacing.x);
    ImGui::BeginDisabled(!there);
    if (ImGui::Button(sure_ ? "Delete?" : "Delete", {width("Delete?"), 0})) {
        if (sure_) {
            commands.emplace_back(DeleteParameterSet{name_});
        }
        sure_ = !sure_;
    }
    ImGui::EndDisabled();
}

void CustomizerPanel::draw(const Rectangle& place, const Customizer& customizer, const Fonts& fonts,
                           Commands& commands) {
    if (place.empty()) {
        return;
    }
    if (begin_panel("Customizer", place)) {
        bold_text("Customizer", fonts);
        if (customizer.parameters().empty()) {
            ImGui::PushTextWrapPos(0);
            ImGui::TextDisabled(
                "The file has no parameters: variables at its top, with a number, a text, true, false or a list.");
            ImGui::PopTextWrapPos();
        } else {
            sets(customizer, commands);
        }
        error_text(customizer.error());
        for (const std::string& group : groups_of(customizer)) {
            if (!ImGui::CollapsingHeader(group.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) {
                continue;
            }
            for (const Parameter& parameter : customizer.parameters()) {
                if (parameter.group == group) {
                    draw_row(customizer, parameter, commands);
                }
            }
        }
    }
    ImGui::End();
}

}  // namespace ui
