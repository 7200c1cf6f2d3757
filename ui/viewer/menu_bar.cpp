#include <imgui.h>

#include <cstring>
#include <string>

#include "ui/viewer/panels.h"

namespace ui {

namespace {

void styles_menu(const Session& session, Commands& commands) {
    for (std::size_t i = 0; i < npr::styles().size(); ++i) {
        const std::string label(npr::styles()[i].label);
        if (ImGui::MenuItem(label.c_str(), nullptr, i == session.view().style())) {
            commands.emplace_back(SetStyle{i});
        }
    }
    ImGui::Separator();
}

/// Which engine draws, and what `auto` goes by.
void engines_menu(const Session& session, const PictureInfo& picture, Commands& commands) {
    const goldfeather::EngineInfo* wanted = session.view().picture.engine;
    if (ImGui::MenuItem("Automatic", nullptr, wanted == nullptr)) {
        commands.emplace_back(SetEngine{});
    }
    for (const goldfeather::EngineInfo& engine : goldfeather::engines()) {
        if (ImGui::MenuItem(std::string(engine.name).c_str(), nullptr, wanted == &engine)) {
            commands.emplace_back(SetEngine{&engine});
        }
    }
    if (picture.engine.reason.empty()) {
        return;
    }
    ImGui::Separator();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + 24 * ImGui::GetFontSize());
    ImGui::TextDisabled("%s drew %d layers: %s", std::string(picture.engine.engine->name).c_str(), picture.walk.layers,
                        picture.engine.reason.c_str());
    ImGui::PopTextWrapPos();
}

bool checked(const Session& session, Action tool, Action action) {
    switch (action) {
        case Action::ToggleAxes:
            return session.shown().axes;
        case Action::ToggleScales:
            return session.shown().scales;
        case Action::ToggleGrid:
            return session.shown().grid;
        case Action::ToggleCube:
            return session.shown().cube;
        case Action::TogglePanel:
            return session.shown().panel;
        case Action::ToggleText:
            return session.shown().text;
        case Action::ToggleCustomizer:
            return session.shown().customizer;
        case Action::ToggleTree:
            return session.shown().tree;
        case Action::ToggleAnimation:
            return session.shown().animation;
        case Action::ToggleInspection:
            return session.shown().inspection;
        case Action::ToggleDynamics:
            return session.shown().dynamics;
        case Action::ToggleConsole:
            return session.shown().console;
        case Action::ToggleHole:
            return session.shown().hole;
        default:
            return action == tool;
    }
}

void menu(const char* name, const Session& session, Action tool, Commands& commands) {
    if (std::strcmp(name, "Style") == 0) {
        styles_menu(session, commands);
    }
    for (const ActionInfo& each : actions()) {
        const bool ends_group = each.action == Action::Quit || each.action == Action::Top ||
                                each.action == Action::ToggleProjection || each.action == Action::ClearConsole ||
                                each.action == Action::PlayPause || each.action == Action::Duplicate ||
                                each.action == Action::Palette || each.action == Action::ToggleHole;
        if (std::strcmp(each.menu, name) != 0) {
            continue;
        }
        if (ends_group) {
            ImGui::Separator();
        }
        if (ImGui::MenuItem(each.label, session.settings().keys.first_text(each.action).c_str(),
                            checked(session, tool, each.action))) {
            commands.emplace_back(each.action);
        }
    }
}

/// At the right end of the bar, where there is room: the tools, that in hand in color and underlined.
void tool_buttons(Action tool, const Keys& keys, Commands& commands) {
    float width = 0;
    for (const ActionInfo& each : actions()) {
        width += std::strcmp(each.menu, "Tool") == 0
                     ? ImGui::CalcTextSize(each.label).x + ImGui::GetStyle().ItemSpacing.x * 2
                     : 0;
    }
    const float from = ImGui::GetWindowWidth() - width - ImGui::GetStyle().ItemSpacing.x;
    if (from < ImGui::GetCursorPosX() + ImGui::GetFontSize()) {
        return;
    }
    ImGui::SetCursorPosX(from);
    for (const ActionInfo& each : actions()) {
        if (std::strcmp(each.menu, "Tool") != 0) {
            continue;
        }
        const bool in_hand = each.action == tool;
        ImGui::PushStyleColor(ImGuiCol_Text, in_hand ? theme::accent() : ImGui::GetStyleColorVec4(ImGuiCol_Text));
        if (ImGui::MenuItem(each.label)) {
            commands.emplace_back(each.action);
        }
        if (in_hand) {
            const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
            ImGui::GetWindowDrawList()->AddLine({low.x, high.y - 1}, {high.x, high.y - 1},
                                                ImGui::GetColorU32(theme::accent()), 2);
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", keys.first_text(each.action).c_str());
        }
        ImGui::PopStyleColor();
    }
}

}  // namespace

float draw_menu_bar(const Session& session, const PictureInfo& picture, Action tool, Commands& commands) {
    if (!ImGui::BeginMainMenuBar()) {
        return 0;
    }
    const char* last = "";
    for (const ActionInfo& each : actions()) {
        if (std::strcmp(each.menu, last) == 0) {
            continue;
        }
        last = each.menu;
        if (ImGui::BeginMenu(last)) {
            menu(last, session, tool, commands);
            ImGui::EndMenu();
        }
        if (std::strcmp(last, "Style") == 0 && ImGui::BeginMenu("Engine")) {
            engines_menu(session, picture, commands);
            ImGui::EndMenu();
        }
    }
    tool_buttons(tool, session.settings().keys, commands);
    const float height = ImGui::GetWindowSize().y;
    ImGui::EndMainMenuBar();
    return height;
}

}  // namespace ui
