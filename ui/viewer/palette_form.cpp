#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "ui/viewer/palette.h"
#include "ui/viewer/panel_window.h"

namespace ui {

void PaletteForm::rows(const Keys& keys, bool take, Commands& commands) {
    const float height = std::min<float>(12.5F, static_cast<float>(std::max<std::size_t>(entries_.size(), 1)) + 0.5F) *
                         ImGui::GetTextLineHeightWithSpacing();
    if (!ImGui::BeginChild("actions", {0, height})) {
        ImGui::EndChild();
        return;
    }
    if (entries_.empty()) {
        ImGui::TextDisabled("no action is called so");
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const PaletteEntry& entry = entries_[i];
        ImGui::PushID(static_cast<int>(i));
        const bool clicked = ImGui::Selectable(entry.name.c_str(), i == chosen_);
        if (i == chosen_ && std::exchange(scrolls_, false)) {
            ImGui::SetScrollHereY(0.5F);
        }
        const std::string key = keys.first_text(entry.action);
        if (!key.empty()) {
            ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(key.c_str()).x -
                            ImGui::GetStyle().ItemSpacing.x);
            ImGui::TextDisabled("%s", key.c_str());
        }
        ImGui::PopID();
        if (clicked || (take && i == chosen_)) {
            commands.emplace_back(Action::Close);
            commands.emplace_back(entry.action);
        }
    }
    ImGui::EndChild();
}

void PaletteForm::draw(const Keys& keys, Commands& commands) {
    bool open = true;
    const float width = std::min(30 * ImGui::GetFontSize(), ImGui::GetMainViewport()->Size.x);
    if (begin_floating("All actions", {width, 0}, {0.4F, 0.35F}, open)) {
        bool renew = false;
        if (ImGui::IsWindowAppearing()) {
            typed_.clear();
            ImGui::SetKeyboardFocusHere();
            renew = true;
        }
        ImGui::SetNextItemWidth(-1);
        const std::string before = typed_;
        const bool take =
            ImGui::InputTextWithHint("##typed", "what is to be done", &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
        if (renew || typed_ != before) {
            entries_ = palette_entries(typed_);
            chosen_ = 0;
            scrolls_ = true;
        }
        const int step = (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow)) ? 1 : 0) -
                         (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow)) ? 1 : 0);
        if (step != 0 && !entries_.empty()) {
            const auto count = static_cast<int>(entries_.size());
            chosen_ = static_cast<std::size_t>((static_cast<int>(chosen_) + step + count) % count);
            scrolls_ = true;
        }
        rows(keys, take, commands);
    }
    end_floating();
    if (!open) {
        commands.emplace_back(Action::Close);
    }
}

}  // namespace ui
