// A part of the interface that fills a rectangle.
#pragma once

#include <imgui.h>

#include "ui/viewer/layout.h"

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

}  // namespace ui
