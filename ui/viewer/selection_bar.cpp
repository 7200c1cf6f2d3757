#include <imgui.h>

#include <fmt/format.h>

#include "ui/viewer/panel_window.h"
#include "ui/viewer/panels.h"

namespace ui {

namespace {

/// Which of the surfaces behind the point it is, and what.
void title_row(const Selection& selection, const Fonts& fonts, Commands& commands) {
    const SelectedSurface& selected = selection.current();
    if (selection.count() > 1) {
        if (ImGui::ArrowButton("nearer", ImGuiDir_Left)) {
            commands.emplace_back(StepSelection{-1});
        }
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%zu of %zu", selection.index() + 1, selection.count());
        ImGui::SameLine();
        if (ImGui::ArrowButton("farther", ImGuiDir_Right)) {
            commands.emplace_back(StepSelection{1});
        }
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
    }
    bold_text(selected.title.c_str(), fonts);
    const glm::dvec3& p = selected.surface.point;
    ImGui::SameLine();
    ImGui::TextDisabled("%s", fmt::format("at [{:.4g}, {:.4g}, {:.4g}]", p.x, p.y, p.z).c_str());
}

void call_rows(const SelectedSurface& selected, Commands& commands) {
    for (std::size_t i = 0; i < selected.calls.size(); ++i) {
        const SelectedCall& call = selected.calls[i];
        ImGui::PushID(static_cast<int>(i));
        if (call.explained) {
            if (ImGui::SmallButton("What it does")) {
                commands.emplace_back(Explain{*call.explained});
            }
            ImGui::SameLine();
        }
        if (ImGui::Selectable(call.call.c_str()) && call.text.text) {
            commands.emplace_back(ShowText{call.text});
        }
        ImGui::SameLine();
        ImGui::TextDisabled("%s", call.place.c_str());
        ImGui::PopID();
    }
}

/// A ring about the point, dark and light, so that it is seen on any ground.
void mark(const Rectangle& place, const base::Camera& camera, const glm::dvec3& point, float scale) {
    const base::View view(camera, glm::max(glm::ivec2(place.size), 1), point, point);
    const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(point, 1);
    if (clip.w <= 0) {
        return;  // Behind the eye.
    }
    const glm::vec2 at(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w);
    const ImVec2 center{place.corner.x + at.x * place.size.x, place.corner.y + at.y * place.size.y};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({place.corner.x, place.corner.y}, {place.corner.x + place.size.x, place.corner.y + place.size.y});
    list.AddCircle(center, 6 * scale, IM_COL32(20, 20, 20, 255), 0, 4 * scale);
    list.AddCircle(center, 6 * scale, IM_COL32(255, 255, 255, 255), 0, 2 * scale);
    list.PopClipRect();
}

}  // namespace

void draw_selection(const Rectangle& place, const Session& session, const Fonts& fonts, float scale,
                    Commands& commands) {
    const Selection& selection = session.selection();
    if (selection.empty() || place.empty()) {
        return;
    }
    const HeldPart& held = session.held();
    const glm::dvec3 point = selection.current().surface.point;
    const bool moved = held.occurrence == session.selected_occurrence();
    mark(place, session.view().picture.camera, moved ? glm::dvec3(held.motion() * glm::dvec4(point, 1)) : point, scale);
    // As high as it must be, up to a third of the picture; longer ways are scrolled.
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const float wanted = (static_cast<float>(selection.current().calls.size()) + 1) * row +
                         2 * ImGui::GetStyle().WindowPadding.y + ImGui::GetStyle().ItemSpacing.y;
    const float height = std::min(wanted, place.size.y / 3);
    const Rectangle bar{{place.corner.x, place.corner.y + place.size.y - height}, {place.size.x, height}};
    ImGui::SetNextWindowBgAlpha(0.92F);
    if (begin_panel("Selection", bar)) {
        title_row(selection, fonts, commands);
        call_rows(selection.current(), commands);
    }
    ImGui::End();
}

}  // namespace ui
