// Colors and fonts of the interface.
#pragma once

#include <imgui.h>

namespace ui {

namespace theme {

inline const ImVec4 kText{0.88F, 0.89F, 0.91F, 1};
inline const ImVec4 kFaint{0.56F, 0.59F, 0.64F, 1};
inline const ImVec4 kAccent{0.30F, 0.58F, 0.94F, 1};
inline const ImVec4 kWarning{0.95F, 0.76F, 0.35F, 1};
inline const ImVec4 kError{1.00F, 0.47F, 0.43F, 1};
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
void apply_theme(float scale);

/// Replaces the context's fonts: the system's where there are any known, else ImGui's own.
[[nodiscard]] Fonts load_fonts(float scale);

}  // namespace ui
