// The form for opening a file, and what the window shows while nothing is open.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "ui/viewer/commands.h"
#include "ui/viewer/layout.h"
#include "ui/viewer/open_source.h"
#include "ui/viewer/theme.h"

namespace ui {

/// To be drawn between ImGui::NewFrame and ImGui::Render; keeps the folder that was looked at.
class OpenForm {
  public:
    /// Begins in this folder.
    explicit OpenForm(std::filesystem::path folder);

    /// Adds to `commands` what the user asks for.
    void draw(std::span<const std::string> recent, const Fonts& fonts, Commands& commands);

  private:
    void look_into(const std::filesystem::path& folder);
    void list(Commands& commands);
    void take_typed(Commands& commands);
    /// Begins a new program, where that was asked for twice.
    void create(const std::filesystem::path& path, Commands& commands);

    std::filesystem::path folder_;
    std::vector<FolderEntry> entries_;
    std::string typed_;  ///< A name in the folder, or a path.
    std::string error_;
    std::filesystem::path creates_;  ///< A program that is not there, as was told; asked for once more it is made.
    bool focus_ = false;
};

/// Over the picture, where nothing is open: how to begin, and the files of last time.
void draw_start(const Rectangle& place, std::span<const std::string> recent, const Fonts& fonts, Commands& commands);

}  // namespace ui
