#pragma once

#include <imgui.h>

#include <glm/glm.hpp>

namespace ui {

/// A place in the window as ImGui has it.
inline ImVec2 window_point(const glm::dvec2& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

}  // namespace ui
