#include <imgui.h>

#include <string>

#include <fmt/format.h>

#include "ui/viewer/panel_window.h"
#include "ui/viewer/panels.h"

namespace ui {

namespace {

/// Lines of which each is looked at in every frame, so that they can be of any height; more are one high each.
constexpr std::size_t kMostWrapped = 1000;

ImVec4 color_of(LineKind kind) {
    switch (kind) {
        case LineKind::Error:
            return theme::error();
        case LineKind::Warning:
            return theme::warning();
        case LineKind::Note:
        case LineKind::Excerpt:
            return theme::faint();
        case LineKind::Echo:
            break;
    }
    return theme::text();
}

std::string counted(std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// The upper edge, which can be dragged.
void edge(const Rectangle& place, float& height) {
    const float thickness = 0.35F * ImGui::GetFontSize();
    ImGui::SetCursorPos({0, 0});
    ImGui::InvisibleButton("edge", {place.size.x, thickness});
    const bool held = ImGui::IsItemActive();
    if (held || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    }
    if (held) {
        height = place.corner.y + place.size.y - ImGui::GetIO().MousePos.y;
    }
    const ImU32 color = ImGui::GetColorU32(held ? ImGuiCol_SeparatorActive : ImGuiCol_Separator);
    ImGui::GetWindowDrawList()->AddLine({place.corner.x, place.corner.y},
                                        {place.corner.x + place.size.x, place.corner.y}, color);
}

void title_row(const MessageLog& messages, const Fonts& fonts, Commands& commands) {
    ImGui::SetCursorPos({ImGui::GetStyle().WindowPadding.x, 0.5F * ImGui::GetFontSize()});
    ImGui::AlignTextToFramePadding();
    bold_text("Console", fonts);
    if (messages.errors() != 0) {
        ImGui::SameLine();
        ImGui::TextColored(theme::error(), "%s", counted(messages.errors(), "error").c_str());
    }
    if (messages.warnings() != 0) {
        ImGui::SameLine();
        ImGui::TextColored(theme::warning(), "%s", counted(messages.warnings(), "warning").c_str());
    }
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::CalcTextSize("CopyClear").x + 4 * style.FramePadding.x + style.ItemSpacing.x;
    ImGui::SameLine(ImGui::GetWindowWidth() - width - style.WindowPadding.x);
    if (ImGui::SmallButton("Copy")) {
        commands.emplace_back(Action::CopyConsole);
    }
    ImGui::SameLine();
    if (ImGui::SmallButton("Clear")) {
        commands.emplace_back(Action::ClearConsole);
    }
}

/// What points to a text shows it when it is clicked.
void line(const LogLine& line, Commands& commands) {
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(line.kind));
    ImGui::TextUnformatted(line.text.data(), line.text.data() + line.text.size());
    ImGui::PopStyleColor();
    if (!line.place) {
        return;
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddLine({from.x, to.y}, to, ImGui::GetColorU32(color_of(line.kind)));
    }
    if (ImGui::IsItemClicked()) {
        commands.emplace_back(ShowText{*line.place});
    }
}

void lines(const MessageLog& messages, const Fonts& fonts, Commands& commands) {
    ImGui::PushFont(fonts.mono);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 1});
    const bool at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY();
    if (messages.lines().size() <= kMostWrapped) {
        ImGui::PushTextWrapPos(0);
        for (const LogLine& log_line : messages.lines()) {
            line(log_line, commands);
        }
        ImGui::PopTextWrapPos();
    } else {
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(messages.lines().size()));
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                line(messages.lines()[static_cast<std::size_t>(i)], commands);
            }
        }
    }
    if (messages.left_out() != 0) {
        ImGui::TextDisabled("… and %zu more messages", messages.left_out());
    }
    if (at_end) {
        ImGui::SetScrollHereY(1);
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

}  // namespace

void draw_console(const Rectangle& place, const Session& session, const Fonts& fonts, float& height,
                  Commands& commands) {
    if (place.empty()) {
        return;
    }
    if (begin_panel("Console", place, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
        const MessageLog& messages = session.document().messages();
        edge(place, height);
        title_row(messages, fonts, commands);
        ImGui::SetCursorPosX(ImGui::GetStyle().WindowPadding.x);
        const bool wraps = messages.lines().size() <= kMostWrapped;
        if (ImGui::BeginChild("lines", {0, 0}, false, wraps ? 0 : ImGuiWindowFlags_HorizontalScrollbar)) {
            lines(messages, fonts, commands);
        }
        ImGui::EndChild();
    }
    ImGui::End();
}

}  // namespace ui
