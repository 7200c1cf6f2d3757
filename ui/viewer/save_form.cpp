#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "npr/accumulate.h"
#include "ui/viewer/panel_window.h"
#include "ui/viewer/panels.h"
#include "ui/viewer/save_path.h"

namespace ui {

namespace {

constexpr int kLargestSide = 16384;

void label(const char* text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ImGui::SameLine(7 * ImGui::GetFontSize());
    ImGui::SetNextItemWidth(-1);
}

}  // namespace

SaveForm::SaveForm(std::string proposed_path, const npr::Picture& first)
    : path_(std::move(proposed_path)), transparent_(first.transparent_background) {}

void SaveForm::propose(std::string path) {
    path_ = std::move(path);
    size_.reset();
}

void SaveForm::set_error(std::string error) {
    error_ = std::move(error);
    focus_ = true;
}

void SaveForm::fields(const PictureRequest& shown, bool& save) {
    if (std::exchange(focus_, false)) {
        ImGui::SetKeyboardFocusHere();
    }
    label("File (PNG)");
    const std::string before = path_;
    save = ImGui::InputText("##path", &path_, ImGuiInputTextFlags_EnterReturnsTrue);
    if (path_ != before) {
        error_.clear();
        overwrites_.clear();
    }
    label("Size");
    glm::ivec2 size = size_.value_or(shown.size);
    if (ImGui::InputInt2("##size", &size.x)) {
        size_ = glm::clamp(size, 1, kLargestSide);
    }
    label("Samples");
    if (ImGui::BeginCombo("##samples", std::to_string(samples_).c_str())) {
        for (const int count : npr::kSampleCounts) {
            if (ImGui::Selectable(std::to_string(count).c_str(), count == samples_)) {
                samples_ = count;
            }
        }
        ImGui::EndCombo();
    }
    label("Background");
    ImGui::Checkbox("transparent", &transparent_);
    error_text(error_);
}

/// False where the form is to close.
bool SaveForm::buttons(bool& save) {
    const float width = 7 * ImGui::GetFontSize();
    ImGui::Spacing();
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * width - ImGui::GetStyle().ItemSpacing.x -
                         ImGui::GetStyle().WindowPadding.x);
    const bool open = !ImGui::Button("Cancel", {width, 0});
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    save |= ImGui::Button(overwrites_.empty() ? "Save" : "Replace", {width, 0});
    ImGui::PopStyleColor();
    return open;
}

void SaveForm::try_to_save(const PictureRequest& shown, Commands& commands) {
    const SavePath wanted = save_path(path_);
    if (!wanted.error.empty()) {
        set_error(wanted.error);
        return;
    }
    std::error_code ignored;
    if (overwrites_ != path_ && std::filesystem::exists(wanted.path, ignored)) {
        set_error(wanted.path.filename().string() + " is there already. Save once more to replace it.");
        overwrites_ = path_;
        return;
    }
    error_.clear();
    overwrites_.clear();
    PictureRequest picture = shown;
    picture.size = size_.value_or(shown.size);
    picture.samples = samples_;
    picture.transparent_background = transparent_;
    commands.emplace_back(WritePicture{wanted.path, picture});
}

void SaveForm::draw(const PictureRequest& shown, Commands& commands) {
    samples_ = samples_ == 0 ? std::max(shown.samples, 4) : samples_;
    bool open = true, save = false;
    const float form_width = std::min(32 * ImGui::GetFontSize(), ImGui::GetMainViewport()->Size.x);
    if (begin_floating("Save picture", {form_width, 0}, {0.4F, 0.4F}, open)) {
        if (ImGui::IsWindowAppearing()) {
            focus_ = true;
            error_.clear();
            overwrites_.clear();
        }
        fields(shown, save);
        open &= buttons(save);
        if (save) {
            try_to_save(shown, commands);
        }
    }
    end_floating();
    if (!open) {
        commands.emplace_back(Action::Close);
    }
}

}  // namespace ui
