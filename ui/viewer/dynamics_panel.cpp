#include "ui/viewer/dynamics_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <utility>

#include <fmt/format.h>

#include "ui/pipeline/motion/character.h"
#include "ui/viewer/inspection_panel.h"
#include "ui/viewer/panel_window.h"

namespace ui {

namespace {

/// What is wrong with a text, with the place below it.
void located_error(const std::string& error, const Fonts& fonts) {
    if (error.empty()) {
        return;
    }
    const std::size_t line = error.find('\n');
    error_text(error.substr(0, line));
    if (line != std::string::npos) {
        ImGui::PushFont(fonts.mono);
        ImGui::PushStyleColor(ImGuiCol_Text, theme::error());
        ImGui::TextUnformatted(error.c_str() + line + 1);
        ImGui::PopStyleColor();
        ImGui::PopFont();
    }
}

/// Lines that can be edited and taken away, each with what is wrong with it.
void edit_lines(const char* id, std::vector<std::string>& lines, const std::vector<std::string>& errors,
                const Fonts& fonts) {
    ImGui::PushID(id);
    std::size_t removed = lines.size();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetNextItemWidth(-1.8F * ImGui::GetFontSize());
        ImGui::InputText("##line", &lines[i]);
        ImGui::SameLine(0, 4);
        if (ImGui::Button("×", {-1, 0})) {
            removed = i;
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("Take it away");
        }
        located_error(i < errors.size() ? errors[i] : std::string(), fonts);
        ImGui::PopID();
    }
    if (removed < lines.size()) {
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(removed));
    }
    ImGui::PopID();
}

/// A line that is added to the others by Enter.
void new_line(const char* id, const char* hint, std::string& typed, std::vector<std::string>& lines) {
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint(id, hint, &typed, ImGuiInputTextFlags_EnterReturnsTrue) && !typed.empty()) {
        lines.push_back(std::exchange(typed, {}));
        ImGui::SetKeyboardFocusHere(-1);
    }
}

void group_title(const char* text, const Fonts& fonts) {
    ImGui::Dummy({0, 0.3F * ImGui::GetFontSize()});
    bold_text(text, fonts);
}

/// For a shell.
std::string shell_quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return result + "'";
}

}  // namespace

void DynamicsPanel::depictions(const Session& session, const Fonts& fonts, GlyphTexts& texts, Commands& commands) {
    bold_text("Depictions of motion", fonts);
    edit_lines("depictions", texts.depictions, session.dynamics().errors().depictions, fonts);
    new_line("##depiction", "path {ball} [0,1], then Enter", new_depiction_, texts.depictions);
    const std::vector<std::string> names = technique_names();
    ImGui::SetNextItemWidth(6.5F * ImGui::GetFontSize());
    if (ImGui::BeginCombo("##technique", names[static_cast<std::size_t>(technique_)].c_str())) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (ImGui::Selectable(names[i].c_str(), technique_ == static_cast<int>(i))) {
                technique_ = static_cast<int>(i);
            }
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    if (ImGui::Button("Of what is selected", {-1, 0})) {
        commands.emplace_back(DynamicsCommand(DepictSelected{names[static_cast<std::size_t>(technique_)]}));
    }
}

void DynamicsPanel::rules(const Session& session, const Fonts& fonts, GlyphTexts& texts) {
    if (texts.rules_file.empty()) {
        ImGui::SetNextItemWidth(-1);
        if (ImGui::InputTextWithHint("##rules", "file of rules, then Enter", &rules_file_,
                                     ImGuiInputTextFlags_EnterReturnsTrue)) {
            texts.rules_file = rules_file_;
        }
        return;
    }
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(("Rules of " + texts.rules_file).c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 1.6F * ImGui::GetFontSize());
    if (ImGui::Button("×##rules", {-1, 0})) {
        texts.rules_file.clear();
    }
    located_error(session.dynamics().errors().rules, fonts);
}

/// What moves, each with a button for the technique.
void DynamicsPanel::bodies(const Session& session, GlyphTexts& texts, Commands& commands) {
    const Dynamics& dynamics = session.dynamics();
    if (const auto seconds = dynamics.looking_for()) {
        if (ImGui::Button(fmt::format("Looking for what moves: cancel ({} s)###look", *seconds).c_str(), {-1, 0})) {
            commands.emplace_back(DynamicsCommand(CancelMotion{}));
        }
        return;
    }
    error_text(dynamics.motion_error());
    if (!dynamics.motion()) {
        if (ImGui::Button("Look for what moves###look", {-1, 0})) {
            commands.emplace_back(DynamicsCommand(LookForMotion{}));
        }
        return;
    }
    const Motion& motion = *dynamics.motion();
    if (motion.bodies.empty()) {
        ImGui::TextDisabled("Nothing moves while $t runs");
    }
    const std::string technique = technique_names()[static_cast<std::size_t>(technique_)];
    for (const MovingBody& body : motion.bodies) {
        const std::string what = fmt::format("{} {}", body.name, name(character_of(motion, body).kind));
        if (ImGui::Selectable(what.c_str())) {
            texts.depictions.push_back(fmt::format("{} {{{}}}", technique, body.name));
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("Draws its %s", technique.c_str());
        }
    }
}

void DynamicsPanel::labels(const Session& session, const Fonts& fonts, GlyphTexts& texts, Commands& commands) {
    group_title("Labels", fonts);
    const Dynamics::Errors& errors = session.dynamics().errors();
    error_text(errors.picture);
    ImGui::Checkbox("Number the parts", &texts.annotations.callouts);
    edit_lines("labels", texts.annotations.labels, errors.labels, fonts);
    ImGui::SetNextItemWidth(9 * ImGui::GetFontSize());
    const bool entered = ImGui::InputTextWithHint("##label", "text", &label_, ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::SameLine();
    if (ImGui::Button("At what is selected", {-1, 0}) || entered) {
        commands.emplace_back(DynamicsCommand(LabelSelected{std::exchange(label_, {})}));
    }
    group_title("Arrows", fonts);
    edit_lines("arrows", texts.annotations.arrows, errors.arrows, fonts);
    new_line("##arrow", "x,y,z:x,y,z, then Enter", new_arrow_, texts.annotations.arrows);
}

void DynamicsPanel::draw(const Rectangle& place, const Session& session, const Fonts& fonts, Commands& commands) {
    if (place.empty()) {
        return;
    }
    if (begin_panel("Motion and labels", place)) {
        const GlyphTexts& now = session.dynamics().texts();
        GlyphTexts texts = now;
        depictions(session, fonts, texts, commands);
        rules(session, fonts, texts);
        group_title("What moves", fonts);
        bodies(session, texts, commands);
        labels(session, fonts, texts, commands);
        ImGui::Dummy({0, 0.3F * ImGui::GetFontSize()});
        if (ImGui::Button("Copy as options", {-1, 0})) {
            ask(commands, CopyText{options_of(now)});
        }
        if (texts != now) {
            commands.emplace_back(DynamicsCommand(SetGlyphs{std::move(texts)}));
        }
    }
    ImGui::End();
}

std::string options_of(const GlyphTexts& texts) {
    std::string all;
    const auto add = [&](const char* option, const std::string& value) {
        all += fmt::format("{}{} {}", all.empty() ? "" : " ", option, shell_quoted(value));
    };
    for (const std::string& depiction : texts.depictions) {
        add("--depict", depiction);
    }
    if (!texts.rules_file.empty()) {
        add("--depict-rules", texts.rules_file);
    }
    for (const std::string& label : texts.annotations.labels) {
        add("--label", label);
    }
    for (const std::string& arrow : texts.annotations.arrows) {
        add("--arrow", arrow);
    }
    if (texts.annotations.callouts) {
        all += all.empty() ? "--callouts" : " --callouts";
    }
    return all;
}

}  // namespace ui
