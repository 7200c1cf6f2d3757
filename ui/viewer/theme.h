// Colors and fonts of the interface.
#pragma once

#include <imgui.h>

namespace ui {

namespace theme {

// As apply_theme() has set them for the current ImGui context.
[[nodiscard]] inline ImVec4 text() {
    return ImGui::GetStyleColorVec4(ImGuiCol_Text);
}
[[nodiscard]] inline ImVec4 faint() {
    return ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
}
[[nodiscard]] inline ImVec4 accent() {
    return ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
}
[[nodiscard]] inline bool light() {
    return ImGui::GetStyleColorVec4(ImGuiCol_WindowBg).x > 0.5F;
}
[[nodiscard]] inline ImVec4 warning() {
    return light() ? ImVec4{0.58F, 0.38F, 0.00F, 1} : ImVec4{0.95F, 0.76F, 0.35F, 1};
}
[[nodiscard]] inline ImVec4 error() {
    return light() ? ImVec4{0.75F, 0.13F, 0.11F, 1} : ImVec4{1.00F, 0.47F, 0.43F, 1};
}
[[nodiscard]] inline ImVec4 good() {
    return light() ? ImVec4{0.13F, 0.52F, 0.20F, 1} : ImVec4{0.40F, 0.75F, 0.45F, 1};
}
/// Behind the status line.
[[nodiscard]] inline ImVec4 low_ground() {
    return light() ? ImVec4{0.86F, 0.87F, 0.89F, 1} : ImVec4{0.095F, 0.105F, 0.12F, 1};
}
// Banners over the picture, with white text.
inline const ImVec4 kErrorBanner{0.74F, 0.15F, 0.15F, 1};
inline const ImVec4 kNoteBanner{0.20F, 0.36F, 0.58F, 1};
inline const ImVec4 kGoneBanner{0.70F, 0.45F, 0.06F, 1};

}  // namespace theme

/// The fonts of an interface; owned by the ImGui context.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* bold = nullptr;
    ImFont* mono = nullptr;
};

/// Colors and measures for the current ImGui context, `scale` times those of a common display.
void apply_theme(float scale, bool light);

/// Replaces the context's fonts: the system's where there are any known, else ImGui's own.
[[nodiscard]] Fonts load_fonts(float scale);

}  // namespace ui
