#include <imgui.h>

#include "ui/viewer/panels.h"
#include "ui/viewer/picture_places.h"

namespace ui {

void draw_ghost(const Rectangle& place, const Session& session, float scale) {
    const Ghost& ghost = session.ghost();
    if (ghost.triangles.empty() || place.empty()) {
        return;
    }
    const base::Camera& camera = session.view().picture.camera;
    const base::View view(camera, glm::max(glm::ivec2(place.size), 1), camera.target, camera.target);
    const HeldPart& held = session.held();
    const bool moved = held.occurrence == session.selected_occurrence();
    const glm::dmat4 clip_from_text = view.clip_from_world() * (moved ? held.motion() : glm::dmat4(1.0));
    const auto at = [&](const glm::dvec3& point) -> std::optional<ImVec2> {
        const glm::dvec4 clip = clip_from_text * glm::dvec4(point, 1);
        if (clip.w <= 0) {
            return std::nullopt;
        }
        const glm::vec2 share(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w);
        return ImVec2{place.corner.x + share.x * place.size.x, place.corner.y + share.y * place.size.y};
    };
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({place.corner.x, place.corner.y}, {place.corner.x + place.size.x, place.corner.y + place.size.y});
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;  // Smooth edges of neighbors would be seen twice.
    const ImU32 face = ghost.cuts ? IM_COL32(220, 60, 45, 70) : IM_COL32(76, 148, 240, 70);
    const ImU32 edge = ghost.cuts ? IM_COL32(150, 25, 20, 220) : IM_COL32(30, 80, 170, 220);
    for (const auto& [p, q, r] : ghost.triangles) {
        const auto a = at(p), b = at(q), c = at(r);
        // Only those that face the eye: y is down, so that these turn clockwise on the screen.
        if (a && b && c && (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x) < 0) {
            list.AddTriangleFilled(*a, *b, *c, face);
        }
    }
    list.Flags = flags;
    for (const auto& [from, to] : ghost.creases) {
        const auto a = at(from), b = at(to);
        if (a && b) {
            list.AddLine(*a, *b, edge, scale);
        }
    }
    list.PopClipRect();
}

}  // namespace ui
