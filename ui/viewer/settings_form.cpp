#include "ui/viewer/settings_form.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "ui/viewer/mouse_preset.h"
#include "ui/viewer/panel_window.h"

namespace ui {

namespace {

void setting_label(const char* text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ImGui::SameLine(8 * ImGui::GetFontSize());
    ImGui::SetNextItemWidth(-1);
}

std::string percent(double size) {
    return fmt::format("{:.0f} %", 100 * size);
}

}  // namespace

void SettingsForm::look(const Settings& settings, Commands& commands) {
    setting_label("Mouse");
    if (ImGui::BeginCombo("##mouse", mouse_presets()[settings.mouse].name)) {
        for (std::size_t i = 0; i < mouse_presets().size(); ++i) {
            if (ImGui::Selectable(mouse_presets()[i].name, i == settings.mouse)) {
                commands.emplace_back(SetMouse{i});
            }
        }
        ImGui::EndCombo();
    }
    ImGui::PushStyleColor(ImGuiCol_Text, theme::faint());
    ImGui::TextWrapped("%s; the wheel zooms, a left click selects.", mouse_presets()[settings.mouse].text);
    ImGui::PopStyleColor();
    setting_label("Theme");
    if (ImGui::BeginCombo("##theme", settings.light ? "light" : "dark")) {
        for (const bool light : {false, true}) {
            if (ImGui::Selectable(light ? "light" : "dark", light == settings.light)) {
                commands.emplace_back(SetLightTheme{light});
            }
        }
        ImGui::EndCombo();
    }
    setting_label("Size of the text");
    if (ImGui::BeginCombo("##size", percent(settings.text_size).c_str())) {
        for (const double size : kTextSizes) {
            if (ImGui::Selectable(percent(size).c_str(), size == settings.text_size)) {
                commands.emplace_back(SetTextSize{size});
            }
        }
        ImGui::EndCombo();
    }
}

void SettingsForm::keys(const Keys& keys, const Fonts& fonts, Commands& commands) {
    ImGui::Spacing();
    bold_text("Keys", fonts);
    ImGui::SameLine(8 * ImGui::GetFontSize());
    ImGui::BeginDisabled(keys.changed().empty());
    if (ImGui::SmallButton("All as by default")) {
        commands.emplace_back(ResetKeys{});
    }
    ImGui::EndDisabled();
    if (ImGui::BeginChild("keys", {0, 0}) && ImGui::BeginTable("table", 2)) {
        ImGui::TableSetupColumn("action");
        ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, 12 * ImGui::GetFontSize());
        for (const ActionInfo& each : actions()) {
            ImGui::TableNextColumn();
            ImGui::AlignTextToFramePadding();
            ImGui::Text("%s: %s", each.menu, each.label);
            ImGui::TableNextColumn();
            std::string shown;
            for (const Chord& chord : keys.of(each.action)) {
                shown += (shown.empty() ? "" : ", ") + text(chord);
            }
            const bool learns = learns_ == each.action;
            const std::string button = (learns ? "press a key…" : shown) + "##" + each.label;
            if (ImGui::Button(button.c_str(), {-1, 0})) {
                learns_ = learns ? std::nullopt : std::optional(each.action);
            }
        }
        ImGui::EndTable();
    }
    ImGui::EndChild();
}

void SettingsForm::draw(const Settings& settings, const Fonts& fonts, Commands& commands) {
    const ImGuiViewport& window = *ImGui::GetMainViewport();
    const float font = ImGui::GetFontSize();
    bool open = true;
    const ImVec2 size{std::min(34 * font, window.Size.x - 2 * font), std::min(34 * font, window.Size.y - 4 * font)};
    if (begin_floating("Settings", size, {0.4F, 0.5F}, open)) {
        look(settings, commands);
        keys(settings.keys, fonts, commands);
    }
    end_floating();
    if (!open) {
        commands.emplace_back(Action::Close);
    }
}

}  // namespace ui
