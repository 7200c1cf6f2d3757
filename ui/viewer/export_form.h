// The form for writing the model to a file.
#pragma once

#include <string>
#include <utility>

#include "ui/viewer/commands.h"

namespace ui {

/// To be drawn between ImGui::NewFrame and ImGui::Render; keeps what was typed.
class ExportForm {
  public:
    explicit ExportForm(std::string proposed_path) : path_(std::move(proposed_path)) {}
    /// Another path is proposed.
    void propose(std::string path) { path_ = std::move(path); }

    void draw(Commands& commands);

  private:
    void try_to_export(Commands& commands);

    std::string path_;
    bool focus_ = false;
    std::string overwrites_;  ///< The path that is there already, as was told; exporting once more replaces it.
    std::string error_;
};

}  // namespace ui
