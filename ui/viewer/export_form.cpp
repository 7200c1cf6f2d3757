#include "ui/viewer/export_form.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ui/viewer/panel_window.h"
#include "ui/viewer/save_path.h"

namespace ui {

void ExportForm::try_to_export(Commands& commands) {
    const SavePath wanted = export_path(path_);
    std::error_code ignored;
    if (!wanted.error.empty()) {
        error_ = wanted.error;
        focus_ = true;
    } else if (overwrites_ != path_ && std::filesystem::exists(wanted.path, ignored)) {
        error_ = wanted.path.filename().string() + " is there already. Export once more to replace it.";
        overwrites_ = path_;
        focus_ = true;
    } else {
        error_.clear();
        overwrites_.clear();
        commands.emplace_back(ExportModel{wanted.path});
        commands.emplace_back(Action::Close);
    }
}

void ExportForm::draw(Commands& commands) {
    bool open = true, take = false;
    const float width = std::min(34 * ImGui::GetFontSize(), ImGui::GetMainViewport()->Size.x);
    if (begin_floating("Export", {width, 0}, {0.4F, 0.4F}, open)) {
        if (ImGui::IsWindowAppearing()) {
            focus_ = true;
            error_.clear();
            overwrites_.clear();
        }
        ImGui::TextDisabled("%s", fmt::format("{}", fmt::join(export_suffixes(), " ")).c_str());
        if (std::exchange(focus_, false)) {
            ImGui::SetKeyboardFocusHere();
        }
        const std::string before = path_;
        const float button = 7 * ImGui::GetFontSize();
        ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
        take = ImGui::InputText("##path", &path_, ImGuiInputTextFlags_EnterReturnsTrue);
        if (path_ != before) {
            error_.clear();
            overwrites_.clear();
        }
        ImGui::SameLine();
        take |= ImGui::Button(overwrites_.empty() ? "Export" : "Replace", {button, 0});
        error_text(error_);
        if (take) {
            try_to_export(commands);
        }
    }
    end_floating();
    if (!open) {
        commands.emplace_back(Action::Close);
    }
}

}  // namespace ui
