// What inspections mark in the picture.
#include <imgui.h>

#include <fmt/format.h>

#include "ui/viewer/inspection_panel.h"
#include "ui/viewer/picture_places.h"
#include "ui/viewer/tone_legend.h"
#include "ui/viewer/window_point.h"

namespace ui {

namespace {

constexpr ImU32 kMarkEdge = IM_COL32(20, 20, 20, 255), kMarkLight = IM_COL32(255, 255, 255, 255),
                kMarked = IM_COL32(240, 60, 40, 255);

/// A text on a ground of its own, so that it is seen on everything.
void size_label(ImDrawList& list, const glm::dvec2& at, const std::string& text, const Fonts& fonts, float scale) {
    const ImFont& font = *fonts.text;
    const ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, text.c_str());
    const ImVec2 corner = window_point(at), end{corner.x + size.x + 6 * scale, corner.y + size.y + 2 * scale};
    list.AddRectFilled(corner, end, IM_COL32(20, 20, 20, 190), 3 * scale);
    list.AddText(&font, font.FontSize, {corner.x + 3 * scale, corner.y + scale}, kMarkLight, text.c_str());
}

void ring(ImDrawList& list, const glm::dvec2& at, ImU32 color, float radius, float scale) {
    list.AddCircle(window_point(at), radius * scale, kMarkEdge, 0, 4.5F * scale);
    list.AddCircle(window_point(at), radius * scale, color, 0, 2.5F * scale);
}

/// A ring, the line that is measured, and how long that is.
void draw_marked(ImDrawList& list, const Rectangle& place, const base::Camera& camera, const InspectedPlace& marked,
                 const Fonts& fonts, float scale) {
    const auto at = place_of(camera, place, marked.point);
    if (!at) {
        return;
    }
    if (marked.direction) {
        if (const auto to = place_of(camera, place, marked.point + marked.value * *marked.direction)) {
            list.AddLine(window_point(*at), window_point(*to), kMarkEdge, 5 * scale);
            list.AddLine(window_point(*at), window_point(*to), kMarked, 2.5F * scale);
        }
    }
    ring(list, *at, kMarked, 14, scale);
    size_label(list, *at + glm::dvec2(18, -38) * static_cast<double>(scale), marked.headline, fonts, scale);
}

}  // namespace

void draw_inspected(const Rectangle& place, const InspectionView& view, float scale) {
    if (place.empty()) {
        return;
    }
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({place.corner.x, place.corner.y}, {place.corner.x + place.size.x, place.corner.y + place.size.y});
    const base::Camera& camera = view.session.view().picture.camera;
    const auto& map = view.inspection.thickness();
    if (view.session.view().thickness && map && map->range > 0) {
        draw_tone_legend(place, map->range, thickness_tone, view.session.view().picture.scheme.background, view.fonts,
                         scale);
        for (const ThinPlace& thin : map->places) {
            if (const auto at = place_of(camera, place, thin.point)) {
                ring(list, *at, kMarkLight, 7, scale);
                size_label(list, *at + glm::dvec2(11, -9) * static_cast<double>(scale),
                           fmt::format("{:.3g}", thin.value), view.fonts, scale);
            }
        }
    }
    if (const auto& marked = view.inspection.marked()) {
        draw_marked(list, place, camera, *marked, view.fonts, scale);
    }
    list.PopClipRect();
}

}  // namespace ui
