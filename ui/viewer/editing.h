// The text of the main file, as it is edited in the window: what becomes of it on disk.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "ui/pipeline/editing/recovery.h"
#include "ui/pipeline/editing/text_document.h"
#include "ui/viewer/revision.h"

namespace ui {

class Editing {
  public:
    /// There is nothing to be edited.
    Editing() : recovery_({}, {}) {}
    /// Reads the source's file. `settings`: beside that file, in a folder "recovery", lies what is not saved; empty:
    /// that is not kept.
    Editing(const Source& source, const std::filesystem::path& settings);

    /// The source is a program in a file, which could be read.
    [[nodiscard]] bool possible() const { return possible_; }
    [[nodiscard]] const TextDocument& text() const { return text_; }
    [[nodiscard]] TextDocument& text() { return text_; }
    /// What the language is to read in place of the file; nothing where that has it.
    [[nodiscard]] std::optional<std::string> unsaved_text() const;

    /// Reads the file again: somebody else may have written it.
    TextDocument::FromDisk look_at_disk();
    /// Writes the text to the file, with what somebody else has done to that meanwhile. Gives for people why it is not
    /// written; empty where it is.
    [[nodiscard]] std::string save();

    /// To be called often: keeps what is not saved, a moment after it has changed. `now`: seconds.
    void keep(double now);
    /// What is not saved is given up, for good.
    void discard();

    /// What a killed program has left of this file.
    [[nodiscard]] const std::optional<Recovery::Left>& left() const { return left_; }
    /// Takes it, as a step, with what has become of the file since then; or throws it away.
    void recover(bool take);

  private:
    [[nodiscard]] std::optional<std::string> read();

    std::string path_;
    std::string mark_;  ///< The byte order mark that the file begins with, which is not part of the text.
    bool possible_ = false;
    TextDocument text_;
    Recovery recovery_;
    std::optional<Recovery::Left> left_;
    std::string kept_;                ///< What recovery_ was given last; empty: nothing.
    std::string seen_;                ///< The text at the last keep() …
    double seen_at_ = 0, since_ = 0;  ///< … since when it has been so, and since when it is not kept.
};

}  // namespace ui
