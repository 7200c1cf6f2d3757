#include <imgui.h>

#include <string>

#include <fmt/format.h>

#include "ui/viewer/panel_window.h"
#include "ui/viewer/panels.h"

namespace ui {

namespace {

/// An evaluation that takes longer is worth being canceled.
constexpr int kSoon = 1;  // Seconds.

struct Lamp {
    ImVec4 color;
    std::string text;
};

Lamp lamp(const Session& session) {
    if (const auto seconds = session.evaluating_for()) {
        return {theme::accent(), *seconds < kSoon ? "Evaluating…" : fmt::format("Evaluating… {} s", *seconds)};
    }
    switch (session.document().state()) {
        case DocumentState::Failed:
            return {theme::error(), "Error"};
        case DocumentState::Gone:
            return {theme::warning(), "File is gone"};
        case DocumentState::Good:
        case DocumentState::Evaluating:
            break;
    }
    return {theme::good(), "Ready"};
}

std::string picture_text(const Session& session, const PictureInfo& picture) {
    const std::string style(session.view().picture.style->label);
    const std::string coarse = picture.divisor > 1 ? fmt::format(" at 1/{}", picture.divisor) : "";
    return fmt::format("{}    {}×{}{}    {} of {} samples    {:.0f} ms", style, picture.size.x, picture.size.y, coarse,
                       picture.samples, picture.wanted_samples, picture.ms);
}

}  // namespace

void draw_status(const Rectangle& place, const Session& session, const PictureInfo& picture, const std::string& note,
                 Commands& commands) {
    if (place.empty()) {
        return;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        {ImGui::GetStyle().WindowPadding.x, 0.5F * (place.size.y - ImGui::GetFontSize())});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::low_ground());
    if (begin_panel("Status", place, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
        const Lamp state = lamp(session);
        const float size = ImGui::GetFontSize();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 0.3F * size, at.y + 0.52F * size}, 0.27F * size,
                                                    ImGui::GetColorU32(state.color));
        ImGui::Dummy({0.6F * size, size});
        ImGui::SameLine();
        ImGui::TextUnformatted(state.text.c_str());
        if (session.evaluating_for().value_or(0) >= kSoon) {
            ImGui::SameLine();
            if (ImGui::SmallButton("Cancel")) {
                commands.emplace_back(Action::Cancel);
            }
        }
        if (!note.empty()) {
            ImGui::SameLine(0, size);
            ImGui::TextDisabled("%s", note.c_str());
        }
        const std::string right = picture_text(session, picture);
        const float width = ImGui::CalcTextSize(right.c_str()).x;
        ImGui::SameLine(0, size);
        const float from = place.size.x - width - ImGui::GetStyle().WindowPadding.x;
        if (from >= ImGui::GetCursorPosX()) {  // Else there is no room for both.
            ImGui::SameLine(from);
            ImGui::TextDisabled("%s", right.c_str());
        }
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

}  // namespace ui
