#include "ui/viewer/open_form.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/file.h"
#include "ui/viewer/panel_window.h"
#include "ui/viewer/save_path.h"

namespace ui {

namespace {

/// A row for each of the files; where one is chosen it is opened.
void recent_rows(std::span<const std::string> recent, Commands& commands) {
    for (const std::string& path : recent) {
        ImGui::PushID(path.c_str());
        const std::filesystem::path file(path);
        if (ImGui::Selectable(file.filename().string().c_str())) {
            commands.emplace_back(OpenFile{path});
        }
        ImGui::SameLine();
        ImGui::TextDisabled("%s", file.parent_path().string().c_str());
        ImGui::PopID();
    }
}

}  // namespace

OpenForm::OpenForm(std::filesystem::path folder) : folder_(std::move(folder)) {}

void OpenForm::look_into(const std::filesystem::path& folder) {
    folder_ = folder.lexically_normal();
    entries_ = entries_of(folder_);
    typed_.clear();
    error_.clear();
    focus_ = true;
}

void OpenForm::list(Commands& commands) {
    const float height = 14 * ImGui::GetTextLineHeightWithSpacing();
    std::filesystem::path wanted;
    if (ImGui::BeginChild("files", {0, height}, true)) {
        if (folder_.has_relative_path() && ImGui::Selectable("..")) {
            wanted = folder_.parent_path();
        }
        for (const FolderEntry& entry : entries_) {
            const std::string label = entry.folder ? entry.name + "/" : entry.name;
            if (!ImGui::Selectable(label.c_str(), typed_ == entry.name, ImGuiSelectableFlags_AllowDoubleClick)) {
                continue;
            }
            if (entry.folder) {
                wanted = folder_ / entry.name;
            } else {
                typed_ = entry.name;
                error_.clear();
                if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
                    take_typed(commands);
                }
            }
        }
    }
    ImGui::EndChild();
    if (!wanted.empty()) {
        look_into(wanted);
    }
}

void OpenForm::take_typed(Commands& commands) {
    const std::filesystem::path path = folder_ / with_home(typed_);
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        look_into(path);
    } else if (!std::filesystem::exists(path, error) && path.extension() == ".scad" &&
               std::filesystem::is_directory(path.parent_path(), error)) {
        create(path, commands);
    } else if (!std::filesystem::is_regular_file(path, error)) {
        error_ = "There is no such file.";
        focus_ = true;
    } else if (!can_open(path)) {
        error_ = "Models are .scad and .csg; meshes and drawings .stl, .off, .obj, .amf, .3mf, .svg and .dxf.";
        focus_ = true;
    } else {
        commands.emplace_back(OpenFile{path});
    }
}

void OpenForm::create(const std::filesystem::path& path, Commands& commands) {
    if (creates_ != path) {
        creates_ = path;
        error_ = "There is no such file. Open it once more to begin a new one.";
        focus_ = true;
        return;
    }
    creates_.clear();
    try {
        base::write_file(path, "");
        commands.emplace_back(OpenFile{path});
    } catch (const std::runtime_error& reason) {
        error_ = reason.what();
    }
}

void OpenForm::draw(std::span<const std::string> recent, const Fonts& fonts, Commands& commands) {
    bool open = true;
    const float width = std::min(40 * ImGui::GetFontSize(), ImGui::GetMainViewport()->Size.x);
    if (begin_floating("Open", {width, 0}, {0.4F, 0.45F}, open)) {
        if (ImGui::IsWindowAppearing()) {
            look_into(folder_);
        }
        ImGui::TextDisabled("%s", folder_.string().c_str());
        list(commands);
        if (std::exchange(focus_, false)) {
            ImGui::SetKeyboardFocusHere();
        }
        const float button = 7 * ImGui::GetFontSize();
        ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
        bool take = ImGui::InputTextWithHint("##path", "name or path", &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
        ImGui::SameLine();
        take |= ImGui::Button("Open", {button, 0});
        if (take) {
            take_typed(commands);
        }
        error_text(error_);
        if (!recent.empty()) {
            bold_text("Last time", fonts);
            recent_rows(recent, commands);
        }
    }
    end_floating();
    if (!open) {
        commands.emplace_back(Action::Close);
    }
}

void draw_start(const Rectangle& place, std::span<const std::string> recent, const Fonts& fonts, Commands& commands) {
    const float width = std::min(36 * ImGui::GetFontSize(), place.size.x);
    if (place.empty()) {
        return;
    }
    ImGui::SetNextWindowPos({place.corner.x + 0.5F * place.size.x, place.corner.y + 0.4F * place.size.y},
                            ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.4F * ImGui::GetFontSize());
    if (ImGui::Begin("Start", nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus)) {
        bold_text("csgscope", fonts);
        ImGui::TextWrapped("Open a model, or drop a file here. It is followed while you edit it.");
        if (ImGui::Button("Open…", {8 * ImGui::GetFontSize(), 0})) {
            commands.emplace_back(Action::Open);
        }
        if (!recent.empty()) {
            ImGui::Spacing();
            bold_text("Last time", fonts);
            recent_rows(recent, commands);
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace ui
