#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "ui/viewer/mouse_preset.h"
#include "ui/viewer/panel_window.h"
#include "ui/viewer/panels.h"

namespace ui {

namespace {

void row(const std::string& keys, const char* meaning) {
    ImGui::TableNextColumn();
    ImGui::TextColored(theme::accent(), "%s", keys.c_str());
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", meaning);
}

void title(const char* text, const Fonts& fonts) {
    ImGui::Spacing();
    bold_text(text, fonts);
}

bool begin_rows(const char* id) {
    if (!ImGui::BeginTable(id, 2)) {
        return false;
    }
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 11 * ImGui::GetFontSize());
    ImGui::TableSetupColumn("meaning");
    return true;
}

void mouse(const Settings& settings, const Fonts& fonts) {
    title("Mouse", fonts);
    if (!begin_rows("mouse")) {
        return;
    }
    const MousePreset& preset = mouse_presets()[settings.mouse];
    row(preset.name, preset.text);
    row("Wheel", "Zoom about the pointer");
    row("Click", "Select; again: what lies behind");
    row("Double click", "Center the point of the model");
    ImGui::EndTable();
}

void menu(const char* name, const Keys& shown, const Fonts& fonts) {
    title(name, fonts);
    if (!begin_rows(name)) {
        return;
    }
    for (const ActionInfo& each : actions()) {
        std::string keys;
        for (const Chord& chord : shown.of(each.action)) {
            keys += (keys.empty() ? "" : ", ") + text(chord);
        }
        if (std::strcmp(each.menu, name) != 0 || keys.empty()) {
            continue;
        }
        row(keys, each.label);
    }
    ImGui::EndTable();
}

}  // namespace

void draw_help(const Settings& settings, const Fonts& fonts, Commands& commands) {
    const ImGuiViewport& window = *ImGui::GetMainViewport();
    const float font = ImGui::GetFontSize();
    const ImVec2 size{std::min(56 * font, window.Size.x - 2 * font), std::min(37 * font, window.Size.y - 4 * font)};
    bool open = true;
    if (begin_floating("Keys and mouse", size, {0.5F, 0.5F}, open)) {
        ImGui::Columns(size.x > 48 * font ? 2 : 1, "halves", false);
        mouse(settings, fonts);
        for (const char* name : {"File", "Camera", "Style"}) {
            menu(name, settings.keys, fonts);
        }
        ImGui::NextColumn();
        for (const char* name : {"View", "Tool", "Window", "Help"}) {
            menu(name, settings.keys, fonts);
        }
        ImGui::Columns();
    }
    end_floating();
    if (!open) {
        commands.emplace_back(Action::Close);
    }
}

}  // namespace ui
