#pragma once

#include <imgui.h>

#include <array>
#include <cstddef>

namespace ui {

inline constexpr ImU32 kGizmoShade = IM_COL32(20, 20, 20, 150);  ///< Behind lines, on grounds of any color.
inline constexpr ImU32 kGizmoHovered = IM_COL32(255, 140, 26, 255);

/// Of a handle for the axis of that number, which is under the pointer or not.
inline ImU32 gizmo_color(std::size_t axis, bool hovered, int alpha = 255) {
    constexpr std::array<ImU32, 3> colors{IM_COL32(214, 60, 56, 255), IM_COL32(76, 163, 62, 255),
                                          IM_COL32(62, 116, 220, 255)};
    const ImU32 color = hovered ? kGizmoHovered : colors[axis];
    return (color & ~IM_COL32_A_MASK) | (static_cast<ImU32>(alpha) << IM_COL32_A_SHIFT);
}

}  // namespace ui
