#include <imgui.h>

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "ui/pipeline/editing/text_edit.h"
#include "ui/viewer/panel_window.h"
#include "ui/viewer/panels.h"

namespace ui {

namespace {

/// Begins a note in the upper left corner of the picture, as large as it must be.
bool begin_note(const char* name, const Rectangle& place, float top, float scale) {
    ImGui::SetNextWindowPos({place.corner.x + 12 * scale, place.corner.y + top});
    ImGui::SetNextWindowBgAlpha(0.94F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.4F * ImGui::GetFontSize());
    return ImGui::Begin(name, nullptr,
                        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
}

void end_note() {
    ImGui::End();
    ImGui::PopStyleVar();
}

std::string way_text(const MoveWay& way) {
    if (way.kind == MoveWay::Kind::Wrap) {
        return fmt::format("{} before {}(), line {}", way.put, way.name, way.where.line);
    }
    const char* const what = way.kind == MoveWay::Kind::Variable ? "{}, named in line {}" : "{}(), line {}";
    return fmt::format(fmt::runtime(what), way.name, way.where.line);
}

std::string count_text(const MoveWay& way) {
    const std::string moved = fmt::format("moves {}", way.moved);
    return way.changed > 0 ? fmt::format("{}, changes {}", moved, way.changed) : moved;
}

/// What the way puts in, in place of what.
std::string edits_text(const MoveWay& way, const std::string& text) {
    std::string all;
    for (const TextEdit& edit : way.edits) {
        const std::string before = text.substr(edit.bytes.begin, edit.bytes.end - edit.bytes.begin);
        all += fmt::format("{}{}", all.empty() ? "" : "   ",
                           before.empty() ? "+ " + edit.text : before + " → " + edit.text);
    }
    return all;
}

/// `wide`: what each way puts in stands beside it, not only under the pointer.
void ways_note(const Session& session, const Fonts& fonts, bool wide, Commands& commands) {
    const MoveAnswer& answer = *session.ways();
    if (answer.ways.empty()) {
        bold_text(fmt::format("{} stays where it is", answer.what).c_str(), fonts);
        ImGui::PushTextWrapPos(28 * ImGui::GetFontSize());
        error_text(answer.trouble);
        ImGui::PopTextWrapPos();
        if (ImGui::SmallButton("All right")) {
            commands.emplace_back(TakeWay{});
        }
        return;
    }
    bold_text((answer.what + ' ' + gesture_of(answer.held).told).c_str(), fonts);
    if (!ImGui::BeginTable("ways", wide ? 3 : 2, ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    for (std::size_t i = 0; i < answer.ways.size(); ++i) {
        const MoveWay& way = answer.ways[i];
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::RadioButton(way_text(way).c_str(), i == session.way_taken()) && i != session.way_taken()) {
            commands.emplace_back(TakeWay{i});
        }
        ImGui::PopID();
        const std::string edits = edits_text(way, answer.text);
        if (wide) {
            ImGui::TableNextColumn();
            ImGui::PushFont(fonts.mono);
            ImGui::TextDisabled("%s", edits.c_str());
            ImGui::PopFont();
        } else if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", edits.c_str());
        }
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", count_text(way).c_str());
    }
    ImGui::EndTable();
}

void side(const char* title, const char* button, const std::string& text, const Fonts& fonts, bool& taken) {
    ImGui::TextDisabled("%s", title);
    ImGui::PushFont(fonts.mono);
    ImGui::TextUnformatted(text.empty() ? "(nothing)" : text.c_str());
    ImGui::PopFont();
    taken = ImGui::SmallButton(button);
}

void conflicts_note(const Session& session, const Fonts& fonts, Commands& commands) {
    const auto& conflicts = session.editing().text().conflicts();
    ImGui::PushStyleColor(ImGuiCol_Text, theme::warning());
    bold_text("The file has been changed in the same place", fonts);
    ImGui::PopStyleColor();
    ImGui::TextDisabled("It is saved when you have chosen. %zu left.", conflicts.size());
    for (std::size_t i = 0; i < std::min<std::size_t>(conflicts.size(), 3); ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::Separator();
        bool mine = false, theirs = false;
        side("here", "Keep this", conflicts[i].ours, fonts, mine);
        side("in the file", "Take that", conflicts[i].theirs, fonts, theirs);
        if (mine || theirs) {
            commands.emplace_back(ResolveConflict{i, theirs});
        }
        ImGui::PopID();
    }
}

/// A question with its answers; what each gives.
void question(const char* title, const std::string& text, const std::vector<std::pair<const char*, Command>>& answers,
              Commands& commands) {
    bool open = true;
    const float size = ImGui::GetFontSize();
    if (begin_floating(title, {std::min(30 * size, ImGui::GetMainViewport()->Size.x), 0}, {0.4F, 0.4F}, open)) {
        ImGui::TextWrapped("%s", text.c_str());
        ImGui::Spacing();
        // Return gives the first of them.
        const bool entered =
            !ImGui::IsWindowAppearing() && (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)) ||
                                            ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter)));
        for (const auto& [label, command] : answers) {
            const bool first = label == answers.front().first;
            ImGui::PushStyleColor(ImGuiCol_Button,
                                  ImGui::GetStyleColorVec4(first ? ImGuiCol_ButtonActive : ImGuiCol_Button));
            if (ImGui::Button(label, {8.5F * size, 0}) || (first && entered)) {
                commands.push_back(command);
            }
            ImGui::PopStyleColor();
            ImGui::SameLine();
        }
        ImGui::NewLine();
    }
    end_floating();
    if (!open) {
        commands.emplace_back(Action::Close);
    }
}

}  // namespace

void draw_editing(const Rectangle& place, const Session& session, const Fonts& fonts, float scale, Commands& commands) {
    const std::string name = session.document().file_name();
    if (!place.empty() && !session.editing().text().conflicts().empty()) {
        if (begin_note("Conflicts", place, 12 * scale, scale)) {
            conflicts_note(session, fonts, commands);
        }
        end_note();
    } else if (!place.empty() && session.ways()) {
        if (begin_note("Ways", place, 12 * scale, scale)) {
            constexpr float kWide = 58;  // Letters.
            ways_note(session, fonts, place.size.x > kWide * ImGui::GetFontSize(), commands);
        }
        end_note();
    }
    if (session.shown().leave_form) {
        question("Not saved", fmt::format("{} has edits that are not saved.", name),
                 {{"Save", Leave{Leave::How::Save}},
                  {"Discard", Leave{Leave::How::Discard}},
                  {"Go on editing", Leave{Leave::How::Stay}}},
                 commands);
    } else if (session.shown().recovery_form) {
        question("Recover",
                 fmt::format("The program ended before edits of {} were saved. They can be taken up again; what has "
                             "become of the file since then stays.",
                             name),
                 {{"Recover", Recover{true}}, {"Throw away", Recover{false}}}, commands);
    }
}

}  // namespace ui
