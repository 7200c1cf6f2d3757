#include "ui/viewer/tree_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/viewer/panel_window.h"

namespace ui {

namespace {

/// What is not all of the model, each with the button that ends it.
void left_out(const Source& source, Commands& commands) {
    const auto line = [&](const char* what, const CallAt& call) {
        ImGui::AlignTextToFramePadding();
        ImGui::PushStyleColor(ImGuiCol_Text, theme::warning());
        ImGui::Text("%s %s", what, call.name.c_str());
        ImGui::PopStyleColor();
        ImGui::SameLine();
        ImGui::TextDisabled("line %u", call.line);
        ImGui::SameLine();
    };
    if (source.alone) {
        line("only", *source.alone);
        if (ImGui::SmallButton("All")) {
            commands.emplace_back(ShowAlone{});
        }
    }
    for (std::size_t i = 0; i < source.hidden.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        line("without", source.hidden[i]);
        if (ImGui::SmallButton("Show")) {
            commands.emplace_back(HideCall{source.hidden[i], false});
        }
        ImGui::PopID();
    }
}

}  // namespace

void TreePanel::renew(const Session& session) {
    const auto& document = session.document();
    if (model_ != document.model()) {
        model_ = document.model();
        folded_.clear();
        rows_.clear();
        scrolled_to_ = csg::kNoOccurrence;
        renews_ = true;
        if (model_ && document.model_sources()) {
            rows_ = tree_rows(*model_, *document.model_sources());
        }
    }
    if (!std::exchange(renews_, false)) {
        return;
    }
    const std::vector<char> wanted = filtered(rows_, filter_);
    shown_.clear();
    for (std::size_t i = 0; i < rows_.size();) {
        if (wanted[i] != 0) {
            shown_.push_back(i);
        }
        i = folded_.contains(rows_[i].occurrence) && filter_.empty() ? rows_[i].end : i + 1;
    }
}

void TreePanel::row(const TreeRow& row, bool selected, Commands& commands) {
    const float size = ImGui::GetFontSize();
    const std::size_t self = static_cast<std::size_t>(&row - rows_.data());
    ImGui::PushID(static_cast<int>(self));
    const float right = ImGui::GetContentRegionMax().x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.8F * size * static_cast<float>(std::min(row.depth, 24)));
    if (row.end > self + 1) {
        const bool folded = folded_.contains(row.occurrence);
        if (ImGui::ArrowButton("fold", folded ? ImGuiDir_Right : ImGuiDir_Down)) {
            folded ? (void)folded_.erase(row.occurrence) : (void)folded_.insert(row.occurrence);
            renews_ = true;
        }
    } else {
        ImGui::Dummy({ImGui::GetFrameHeight(), ImGui::GetFrameHeight()});
    }
    ImGui::SameLine(0, 4);
    if (row.color) {
        ImGui::ColorButton("##color", {row.color->r, row.color->g, row.color->b, 1},
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop, {0.8F * size, 0.8F * size});
        ImGui::SameLine(0, 4);
    }
    const float buttons = ImGui::CalcTextSize("HideOnly").x + 5 * ImGui::GetStyle().FramePadding.x;
    const float room = std::max(right - ImGui::GetCursorPosX() - buttons, size);
    if (ImGui::Selectable(row.call.c_str(), selected, 0, {room, 0})) {
        commands.emplace_back(SelectCall{row.occurrence, row.text, row.place});
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s\n%s", row.call.c_str(), row.place.c_str());
    }
    ImGui::SameLine(right - buttons);
    if (ImGui::SmallButton("Hide")) {
        commands.emplace_back(HideCall{row.at, true});
    }
    ImGui::SameLine(0, 4);
    if (ImGui::SmallButton("Only")) {
        commands.emplace_back(ShowAlone{row.at});
    }
    ImGui::PopID();
}

void TreePanel::draw(const Rectangle& place, const Session& session, const Fonts& fonts, Commands& commands) {
    if (place.empty()) {
        return;
    }
    if (begin_panel("Tree", place)) {
        bold_text("Tree", fonts);
        ImGui::SetNextItemWidth(-1);
        renews_ |= ImGui::InputTextWithHint("##filter", "filter", &filter_);
        left_out(session.document().source(), commands);
        renew(session);
        const csg::OccurrenceId selected = session.selected_occurrence();
        if (ImGui::BeginChild("rows")) {
            ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2, 1});
            ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {4, 2});
            const float height = ImGui::GetFrameHeightWithSpacing();
            if (selected != scrolled_to_) {
                scrolled_to_ = selected;
                const auto found = std::find_if(shown_.begin(), shown_.end(),
                                                [&](std::size_t i) { return rows_[i].occurrence == selected; });
                if (found != shown_.end()) {
                    const auto at = static_cast<float>(found - shown_.begin()) * height;
                    const float from = ImGui::GetScrollY(), room = ImGui::GetWindowHeight();
                    if (at < from || at + height > from + room) {
                        ImGui::SetScrollY(std::max(0.0F, at - room / 3));
                    }
                }
            }
            ImGuiListClipper clipper;
            clipper.Begin(static_cast<int>(shown_.size()), height);
            while (clipper.Step()) {
                for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                    const TreeRow& each = rows_[shown_[static_cast<std::size_t>(i)]];
                    row(each, each.occurrence == selected, commands);
                }
            }
            ImGui::PopStyleVar(2);
        }
        ImGui::EndChild();
    }
    ImGui::End();
}

}  // namespace ui
