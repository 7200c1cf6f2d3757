#include <imgui.h>
#include <imgui_stdlib.h>

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "ui/viewer/inspection_panel.h"
#include "ui/viewer/panel_window.h"
#include "ui/viewer/save_path.h"

namespace ui {

namespace {

void amount(const char* sign, const MeasuredSolid& solid) {
    if (solid.volume != 0) {
        ImGui::SameLine();
        ImGui::TextDisabled("%s%s", sign, fmt::format("{:.6g}", solid.volume).c_str());
    }
}

void part_table(const ChangesAnswer& answer) {
    double added = 0, removed = 0;
    for (const PartChange& part : answer.parts) {
        added += part.added.volume;
        removed += part.removed.volume;
    }
    ImGui::TextUnformatted(fmt::format("added {:.6g}, removed {:.6g} mm³", added, removed).c_str());
    if (ImGui::BeginChild("parts")) {
        for (const PartChange& part : answer.parts) {
            using Kind = PartChange::Kind;
            const ImVec4 color = part.kind == Kind::New       ? theme::good()
                                 : part.kind == Kind::Gone    ? theme::error()
                                 : part.kind == Kind::Changed ? theme::warning()
                                                              : theme::faint();
            ImGui::TextColored(color, "%s", name(part.kind));
            ImGui::SameLine(5.2F * ImGui::GetFontSize());
            ImGui::TextUnformatted(
                (part.was.empty() ? part.name : fmt::format("{} (was {})", part.name, part.was)).c_str());
            amount("+", part.added);
            amount("-", part.removed);
        }
    }
    ImGui::EndChild();
}

}  // namespace

void ChangesTab::draw(const InspectionView& view, Commands& commands) {
    const Document& document = view.session.document();
    const auto& shown = document.source().before;
    const auto compare = [&](std::optional<Baseline> with) { ask(commands, CompareWith{std::move(with)}); };
    if (ImGui::RadioButton("The model itself", !shown)) {
        compare(std::nullopt);
    }
    const auto of_tree = [&](const char* label, const char* name, const std::shared_ptr<const csg::Tree>& tree) {
        if (ImGui::RadioButton(label, shown && tree && shown->tree == tree) && tree) {
            compare(Baseline{name, tree, {}});
        }
    };
    of_tree("Changes since it was opened", "it was opened", document.first_tree());
    const bool of_own = shown && !shown->tree && shown->path == document.source().path;
    if (ImGui::RadioButton("Changes since it was saved", of_own) && !document.source().followed().empty()) {
        compare(Baseline{"it was saved", nullptr, document.source().path});
    }
    of_tree("Changes since it was kept", "it was kept", kept_);
    ImGui::SameLine();
    if (ImGui::SmallButton("Keep now")) {
        kept_ = document.tree();
    }
    const bool of_file = shown && !shown->tree && !of_own;
    if (ImGui::RadioButton("Changes since a file", of_file) && of_file) {
        compare(std::nullopt);
    }
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##file", "old.scad, then Enter", &path_, ImGuiInputTextFlags_EnterReturnsTrue)) {
        const std::filesystem::path path = with_home(path_);
        std::error_code problem;
        error_ = std::filesystem::is_regular_file(path, problem) ? "" : path.string() + " is no file";
        if (error_.empty()) {
            compare(Baseline{path.filename().string(), nullptr, path.string()});
        }
    }
    error_text(error_);
    if (!shown) {
        return;
    }
    if (task_button("Volumes, part by part", "changes", view.inspection, commands)) {
        ask(commands, RunPartChanges{parts_.rule(csg::PartRule{csg::PartRule::Kind::Depth, 1, {}})});
    }
    parts_.draw("Parts as the top-level union has them");
    if (const auto& answer = view.inspection.changes()) {
        tell_state(*answer, view.session);
        if (answer->error.empty()) {
            part_table(*answer);
        }
    }
}

}  // namespace ui
