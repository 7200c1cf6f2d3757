#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "npr/accumulate.h"
#include "ui/viewer/panel_window.h"
#include "ui/viewer/panels.h"

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

void SaveForm::draw(const PictureRequest& shown, Commands& commands) {
    if (size_.x == 0) {
        size_ = glm::max(shown.size, 1);
        samples_ = std::max(shown.samples, 4);
    }
    const float font = ImGui::GetFontSize();
    bool open = true;
    const float form_width = std::min(32 * font, ImGui::GetMainViewport()->Size.x);
    if (begin_floating("Save picture", {form_width, 0}, {0.4F, 0.4F}, open)) {
        if (ImGui::IsWindowAppearing()) {
            ImGui::SetKeyboardFocusHere();
        }
        label("File (PNG)");
        bool save = ImGui::InputText("##path", &path_, ImGuiInputTextFlags_EnterReturnsTrue);
        label("Size");
        ImGui::InputInt2("##size", &size_.x);
        size_ = glm::clamp(size_, 1, kLargestSide);
        label("Samples");
        const auto at =
            std::find(npr::kSampleCounts.begin(), npr::kSampleCounts.end(), samples_) - npr::kSampleCounts.begin();
        int chosen = static_cast<int>(at);
        if (ImGui::Combo("##samples", &chosen, "1\0004\0008\00016\0")) {
            samples_ = npr::kSampleCounts[static_cast<std::size_t>(chosen)];
        }
        label("Background");
        ImGui::Checkbox("transparent", &transparent_);
        if (!error_.empty()) {
            ImGui::PushStyleColor(ImGuiCol_Text, theme::kError);
            ImGui::TextWrapped("%s", error_.c_str());
            ImGui::PopStyleColor();
        }
        ImGui::Spacing();
        const float width = 7 * font;
        ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * width - ImGui::GetStyle().ItemSpacing.x -
                             ImGui::GetStyle().WindowPadding.x);
        open &= !ImGui::Button("Cancel", {width, 0});
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        save |= ImGui::Button("Save", {width, 0});
        ImGui::PopStyleColor();
        if (save && !path_.empty()) {
            error_.clear();
            PictureRequest picture = shown;
            picture.size = size_;
            picture.samples = samples_;
            picture.transparent_background = transparent_;
            commands.emplace_back(WritePicture{path_, picture});
        }
    }
    end_floating();
    if (!open) {
        commands.emplace_back(Action::Close);
    }
}

}  // namespace ui
