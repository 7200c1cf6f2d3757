// What the parts of the interface have in common: their windows, and their headings.
#pragma once

#include <imgui.h>

#include <string>

#include "ui/viewer/layout.h"
#include "ui/viewer/theme.h"

namespace ui {

/// Begins an ImGui window that fills `place`; to be ended with ImGui::End whatever it gives.
inline bool begin_panel(const char* name, const Rectangle& place, ImGuiWindowFlags more = 0) {
    ImGui::SetNextWindowPos({place.corner.x, place.corner.y});
    ImGui::SetNextWindowSize({place.size.x, place.size.y});
    return ImGui::Begin(name, nullptr,
                        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                            ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                            ImGuiWindowFlags_NoBringToFrontOnFocus | more);
}

/// Begins an ImGui window that floats over the others, `size` large (0: as its content needs) around a place given as a
/// fraction of the screen; to be ended with end_floating. `open` becomes false where the user closes it.
inline bool begin_floating(const char* name, ImVec2 size, ImVec2 middle, bool& open) {
    const ImVec2 screen = ImGui::GetMainViewport()->Size;
    ImGui::SetNextWindowPos({middle.x * screen.x, middle.y * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.4F * ImGui::GetFontSize());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleColor(ImGuiCol_Border, ImGui::GetStyleColorVec4(ImGuiCol_ButtonHovered));
    return ImGui::Begin(name, &open,
                        ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                            ImGuiWindowFlags_NoMove);
}

inline void end_floating() {
    ImGui::End();
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(2);
}

/// What went wrong, in lines as wide as there is room; nothing where that is empty.
inline void error_text(const std::string& text) {
    if (text.empty()) {
        return;
    }
    ImGui::PushStyleColor(ImGuiCol_Text, theme::error());
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

inline void bold_text(const char* text, const Fonts& fonts) {
    ImGui::PushFont(fonts.bold);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

}  // namespace ui
