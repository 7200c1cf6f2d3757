#include "ui/viewer/text_panel.h"

#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "ui/viewer/panel_window.h"

namespace ui {

namespace {

using csg::scad::SourceFile;
using csg::scad::SourceRange;

std::uint32_t line_count(const SourceFile& text) {
    return text.place(text.text().size()).line;
}

/// A line whose part of the range is marked.
void draw_line(const SourceFile& text, const SourceRange& range, std::uint32_t number, float gutter) {
    const std::string_view line = text.line(number);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight();
    const auto width_of = [&](std::string_view part) {
        return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x;
    };
    if (range.known() && number >= range.line && number <= range.end_line) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float room = ImGui::GetWindowWidth();
        list.AddRectFilled({at.x, at.y}, {at.x + room, at.y + height}, IM_COL32(76, 148, 240, 36));
        const std::size_t begin = number == range.line ? std::min<std::size_t>(range.column - 1, line.size()) : 0;
        const std::size_t end =
            number == range.end_line ? std::min<std::size_t>(range.end_column - 1, line.size()) : line.size();
        if (begin < end) {
            const float from = at.x + gutter + width_of(line.substr(0, begin));
            list.AddRectFilled({from, at.y}, {from + width_of(line.substr(begin, end - begin)), at.y + height},
                               IM_COL32(76, 148, 240, 96), 2);
        }
    }
    ImGui::TextDisabled("%s", fmt::format("{:4}", number).c_str());
    ImGui::SameLine(gutter);
    ImGui::TextUnformatted(line.data(), line.data() + line.size());
}

}  // namespace

void TextPanel::draw(const Rectangle& place, const TextPlace& shown, const Fonts& fonts, Commands& commands) {
    if (place.empty()) {
        return;
    }
    if (begin_panel("Text", place)) {
        if (shown.text == nullptr) {
            bold_text("Text", fonts);
            ImGui::TextDisabled("nothing is open");
            ImGui::End();
            return;
        }
        const std::filesystem::path file(shown.text->name());
        bold_text(file.filename().string().c_str(), fonts);
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", shown.text->name().c_str());
        }
        const float button = ImGui::CalcTextSize("Edit").x + 2 * ImGui::GetStyle().FramePadding.x;
        ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
        if (ImGui::SmallButton("Edit")) {
            commands.emplace_back(
                EditText{shown.text->name(), std::max(shown.range.line, 1U), std::max(shown.range.column, 1U)});
        }
        if (ImGui::BeginChild("lines", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar)) {
            ImGui::PushFont(fonts.mono);
            ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 1});
            const float row = ImGui::GetTextLineHeightWithSpacing();
            const std::uint32_t lines = line_count(*shown.text);
            const bool other = scrolled_to_.text != shown.text || scrolled_to_.range != shown.range;
            if (other) {
                scrolled_to_ = shown;
                const auto line = static_cast<float>(std::max(shown.range.line, 1U) - 1);
                ImGui::SetScrollY(std::max(0.0F, line * row - ImGui::GetWindowHeight() / 3));
            }
            const float gutter = ImGui::CalcTextSize("00000").x;
            ImGuiListClipper clipper;
            clipper.Begin(static_cast<int>(lines), row);
            while (clipper.Step()) {
                for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                    draw_line(*shown.text, shown.range, static_cast<std::uint32_t>(i) + 1, gutter);
                }
            }
            ImGui::PopStyleVar();
            ImGui::PopFont();
        }
        ImGui::EndChild();
    }
    ImGui::End();
}

}  // namespace ui
