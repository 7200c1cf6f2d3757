#include "ui/viewer/text_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "ui/viewer/panel_window.h"

namespace ui {

namespace {

ImU32 color_of(char kind) {
    const bool light = theme::light();
    switch (kind) {
        case 'c':
            return light ? IM_COL32(110, 120, 110, 255) : IM_COL32(118, 132, 118, 255);
        case 's':
            return light ? IM_COL32(160, 80, 20, 255) : IM_COL32(222, 160, 112, 255);
        case 'n':
            return light ? IM_COL32(20, 110, 90, 255) : IM_COL32(150, 208, 170, 255);
        case 'k':
            return light ? IM_COL32(150, 30, 130, 255) : IM_COL32(204, 150, 220, 255);
        case 'f':
            return light ? IM_COL32(30, 80, 180, 255) : IM_COL32(124, 180, 246, 255);
        case '$':
            return light ? IM_COL32(120, 90, 0, 255) : IM_COL32(226, 200, 120, 255);
        default:
            return ImGui::GetColorU32(ImGuiCol_Text);
    }
}

float width_of(std::string_view part) {
    return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x;
}

/// Errors and warnings by the line of the file that they point to; the first of each.
std::map<std::size_t, std::pair<LineKind, std::string>> messages_of(const MessageLog& log, const std::string& name) {
    std::map<std::size_t, std::pair<LineKind, std::string>> messages;
    for (const LogLine& line : log.lines()) {
        if ((line.kind == LineKind::Error || line.kind == LineKind::Warning) && line.place && line.place->text &&
            line.place->text->name() == name && line.place->range.known()) {
            const std::size_t at = line.text.find(": ");
            messages.try_emplace(line.place->range.line - 1, line.kind,
                                 at == std::string::npos ? line.text : line.text.substr(at + 2));
        }
    }
    return messages;
}

}  // namespace

std::size_t TextPanel::line_of(std::size_t byte) const {
    return static_cast<std::size_t>(std::upper_bound(starts_.begin(), starts_.end(), byte) - starts_.begin()) - 1;
}

std::string_view TextPanel::line(std::size_t number) const {
    const std::size_t from = starts_[number];
    std::size_t to = number + 1 < starts_.size() ? starts_[number + 1] - 1 : text_.size();
    to -= to > from && text_[to - 1] == '\r' ? 1 : 0;
    return std::string_view(text_).substr(from, to - from);
}

std::size_t TextPanel::byte_at(std::size_t number, float x) const {
    const std::string_view all = line(number);
    std::size_t best = 0;
    float least = std::abs(x);
    for (std::size_t i = 1; i <= all.size(); ++i) {
        if (i < all.size() && (static_cast<unsigned char>(all[i]) & 0xC0U) == 0x80U) {
            continue;
        }
        const float away = std::abs(x - width_of(all.substr(0, i)));
        if (away > least) {
            break;
        }
        best = i;
        least = away;
    }
    return starts_[number] + best;
}

void TextPanel::renew(const Session& session) {
    const TextPlace& shown = session.text();
    const auto& sources = session.document().sources();
    const bool is_main =
        shown.text == nullptr || (sources && sources->size() > 0 && shown.text->name() == (*sources)[0].name());
    editable_ = is_main && session.editing().possible();
    focused_ = focused_ && editable_;
    const std::string& text = editable_ ? session.editing().text().text() : shown.text ? shown.text->text() : name_;
    name_ = shown.text ? shown.text->name() : session.document().source().path;
    if (text != text_ || starts_.empty()) {
        text_ = editable_ || shown.text ? text : "";
        kinds_ = highlighted(text_);
        starts_ = {0};
        for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1)) {
            starts_.push_back(at + 1);
        }
        if (editable_ && steps_ != session.editing().text().steps() && focused_) {
            caret_.put(session.editing().text().changed_at(), false);  // Undone, or done again.
            follows_ = true;
        }
        caret_.keep_within(text_);
    }
    steps_ = session.editing().text().steps();
    messages_ = messages_of(session.document().messages(), name_);
}

void TextPanel::draw_header(const Session& session, const Fonts& fonts, Commands& commands) const {
    const std::filesystem::path file(name_);
    bold_text(file.filename().string().c_str(), fonts);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", name_.c_str());
    }
    if (editable_ && session.editing().text().unsaved()) {
        ImGui::SameLine();
        ImGui::TextDisabled("not saved");
    }
    const float button = ImGui::CalcTextSize("Edit").x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
    if (ImGui::SmallButton("Edit")) {
        const csg::scad::SourceRange& range = session.text().range;
        commands.emplace_back(EditText{name_, std::max(range.line, 1U), std::max(range.column, 1U)});
    }
}

void TextPanel::draw_line(std::size_t number, float left, float top, float gutter) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string_view shown = line(number);
    const float height = ImGui::GetTextLineHeight(), room = ImGui::GetWindowWidth() + ImGui::GetScrollX();
    const csg::scad::SourceRange& range = scrolled_to_.range;
    const bool as_marked = scrolled_to_.text != nullptr && scrolled_to_.text->text() == text_;
    const auto one = static_cast<std::uint32_t>(number) + 1;
    if (as_marked && range.known() && one >= range.line && one <= range.end_line) {
        list.AddRectFilled({left, top}, {left + room, top + height}, IM_COL32(76, 148, 240, 36));
        const std::size_t begin = one == range.line ? std::min<std::size_t>(range.column - 1, shown.size()) : 0;
        const std::size_t end =
            one == range.end_line ? std::min<std::size_t>(range.end_column - 1, shown.size()) : shown.size();
        if (begin < end) {
            const float from = left + gutter + width_of(shown.substr(0, begin));
            list.AddRectFilled({from, top}, {from + width_of(shown.substr(begin, end - begin)), top + height},
                               IM_COL32(76, 148, 240, 96), 2);
        }
    }
    const std::size_t start = starts_[number], stop = start + shown.size();
    if (focused_ && caret_.selects() && caret_.begin() <= stop && caret_.end() > start) {
        const std::size_t begin = std::max(caret_.begin(), start) - start, end = std::min(caret_.end(), stop) - start;
        const float from = left + gutter + width_of(shown.substr(0, begin));
        const float more = caret_.end() > stop ? 0.5F * height : 0;  // Its end is selected too.
        list.AddRectFilled({from, top}, {from + width_of(shown.substr(begin, end - begin)) + more, top + height},
                           theme::light() ? IM_COL32(120, 170, 240, 130) : IM_COL32(70, 110, 180, 170));
    }
    const std::string label = fmt::format("{:4}", one);
    list.AddText({left, top}, ImGui::GetColorU32(ImGuiCol_TextDisabled), label.c_str());
    float x = left + gutter;
    for (std::size_t i = 0; i < shown.size();) {
        std::size_t end = i + 1;
        while (end < shown.size() && kinds_[start + end] == kinds_[start + i]) {
            ++end;
        }
        list.AddText({x, top}, color_of(kinds_[start + i]), shown.data() + i, shown.data() + end);
        x = left + gutter + width_of(shown.substr(0, end));
        i = end;
    }
    if (focused_ && caret_.at() >= start && caret_.at() <= stop && std::fmod(ImGui::GetTime() - moved_at_, 1.0) < 0.6) {
        const float at = left + gutter + width_of(shown.substr(0, caret_.at() - start));
        list.AddLine({at, top}, {at, top + height}, ImGui::GetColorU32(ImGuiCol_Text), 1.5F);
    }
    draw_message(number, x + height, top);
}

void TextPanel::draw_message(std::size_t number, float left, float top) const {
    const auto found = messages_.find(number);
    if (found == messages_.end()) {
        return;
    }
    const auto& [kind, text] = found->second;
    const ImVec4 color = kind == LineKind::Error ? theme::error() : theme::warning();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float height = ImGui::GetTextLineHeight();
    list.AddRectFilled({left - 0.4F * height, top}, {left + width_of(text) + 0.4F * height, top + height},
                       ImGui::GetColorU32({color.x, color.y, color.z, 0.16F}), 0.25F * height);
    list.AddText({left, top}, ImGui::GetColorU32(color), text.c_str());
}

void TextPanel::draw_lines(const Session& session, Commands& commands) {
    const TextPlace& shown = session.text();
    const float row = ImGui::GetTextLineHeight() + 1;
    if (scrolled_to_.text != shown.text || scrolled_to_.range != shown.range) {
        const bool elsewhere = scrolled_to_.range != shown.range || scrolled_to_.text == nullptr ||
                               shown.text == nullptr || scrolled_to_.text->name() != shown.text->name();
        scrolled_to_ = shown;
        if (elsewhere && !focused_) {
            const auto line = static_cast<float>(std::max(shown.range.line, 1U) - 1);
            ImGui::SetScrollY(std::max(0.0F, line * row - ImGui::GetWindowHeight() / 3));
        }
    }
    const float gutter = ImGui::CalcTextSize("00000").x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const int page = std::max(1, static_cast<int>(ImGui::GetWindowHeight() / row) - 2);
    point(corner.x + gutter, corner.y, row, commands);
    if (focused_) {
        ImGui::GetIO().WantTextInput = true;  // Shortcuts are asked for after this, in the same frame.
        const std::string before = text_;
        if (type(page)) {
            moved_at_ = ImGui::GetTime();
            follows_ = true;
        }
        if (text_ != before) {
            commands.emplace_back(TypeText{text_});
            kinds_ = highlighted(text_);
            starts_ = {0};
            for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1)) {
                starts_.push_back(at + 1);
            }
            steps_ = ~std::size_t{0};
        }
    }
    const auto first = static_cast<std::size_t>(std::max(0.0F, ImGui::GetScrollY() / row));
    const std::size_t last = std::min(starts_.size(), first + static_cast<std::size_t>(page) + 4);
    float width = 0;
    for (std::size_t i = first; i < last; ++i) {
        draw_line(i, corner.x, corner.y + static_cast<float>(i) * row, gutter);
        const auto message = messages_.find(i);
        width = std::max(
            width, width_of(line(i)) + (message == messages_.end() ? 0 : width_of(message->second.second) + 2 * row));
    }
    ImGui::Dummy({gutter + width + row, static_cast<float>(starts_.size()) * row});
    if (std::exchange(follows_, false)) {
        const std::size_t number = line_of(caret_.at());
        const float y = static_cast<float>(number) * row, height = ImGui::GetWindowHeight() - row;
        const float x =
            gutter + width_of(line(number).substr(0, std::min(caret_.at() - starts_[number], line(number).size())));
        const float from_y = ImGui::GetScrollY(), from_x = ImGui::GetScrollX(), room = ImGui::GetWindowWidth() - gutter;
        if (y < from_y || y + row > from_y + height) {
            ImGui::SetScrollY(std::max(0.0F, y < from_y ? y : y + 2 * row - height));
        }
        if (x - gutter < from_x || x > from_x + room) {
            ImGui::SetScrollX(std::max(0.0F, x - room / 2));
        }
    }
}

void TextPanel::draw(const Rectangle& place, const Session& session, const Fonts& fonts, Commands& commands) {
    if (place.empty()) {
        focused_ = false;
        return;
    }
    if (begin_panel("Text", place)) {
        renew(session);
        if (session.text().text == nullptr && !editable_) {
            bold_text("Text", fonts);
            ImGui::TextDisabled("nothing is open");
            ImGui::End();
            return;
        }
        draw_header(session, fonts, commands);
        focused_ = focused_ && !session.shown().covered();
        const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
        if (ImGui::BeginChild("lines", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoNav)) {
            ImGui::PushFont(fonts.mono);
            draw_lines(session, commands);
            ImGui::PopFont();
        }
        ImGui::EndChild();
        if (focused_) {
            ImGui::GetWindowDrawList()->AddRect({corner.x - 3, corner.y - 3},
                                                {corner.x + room.x + 3, corner.y + room.y + 3},
                                                ImGui::GetColorU32(theme::accent()), 3);
        }
    }
    ImGui::End();
}

}  // namespace ui
