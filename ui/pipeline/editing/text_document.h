// The text of a file that is edited by hand: steps that are undone and redone, and what others do to the file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "ui/pipeline/editing/merge_texts.h"
#include "ui/pipeline/editing/text_edit.h"

namespace ui {

class TextDocument {
  public:
    /// `text`: as the file has it.
    explicit TextDocument(std::string text = {}) : text_(text), saved_(std::move(text)) {}

    [[nodiscard]] const std::string& text() const { return text_; }
    /// As the file has it, for all that is known.
    [[nodiscard]] const std::string& saved_text() const { return saved_; }
    [[nodiscard]] bool unsaved() const { return text_ != saved_; }

    /// One step, called `what` ("move cube"). The edits do not overlap. Nothing where they change nothing.
    void edit(std::vector<TextEdit> edits, std::string what);
    /// Another text, as a step that changes what is different. `typing`: it is part of the step before, where that was
    /// typed too, went on where this does, and pause() was not called since.
    void set_text(const std::string& text, std::string what, bool typing = false);
    void pause() { typing_ = false; }

    // False where there is nothing of that kind to be done.
    bool undo();
    bool redo();
    /// What they would undo or do again; empty: nothing.
    [[nodiscard]] std::string undo_what() const { return done_ == 0 ? "" : steps_[done_ - 1].what; }
    [[nodiscard]] std::string redo_what() const { return done_ == steps_.size() ? "" : steps_[done_].what; }
    [[nodiscard]] std::size_t steps() const { return done_; }  ///< That can be undone.
    /// Where the last change of the text, by whatever, ends; to put a cursor there.
    [[nodiscard]] std::size_t changed_at() const { return changed_at_; }

    /// The text is in the file now.
    void set_saved() { saved_ = text_; }

    enum class FromDisk {
        Same,      ///< Nothing new.
        Taken,     ///< There was nothing unsaved: the text is that of the file.
        Merged,    ///< As a step; what was unsaved is so still.
        Conflict,  ///< The same, but for conflicts().
    };
    /// Somebody else has written the file. Whatever happens to the text is a step, which can be undone.
    FromDisk take_from_disk(const std::string& text);
    /// Statements that both have changed. Where there are any the text is not to be saved. Their places follow edits.
    [[nodiscard]] const std::vector<MergeConflict>& conflicts() const { return conflicts_; }
    /// Ends a conflict: what stands in the text stays, or the other takes its place, as a step.
    void resolve(std::size_t conflict, bool take_theirs);

  private:
    struct Change {
        std::size_t at = 0;
        std::string removed, inserted;
    };
    struct Step {
        std::string what;
        std::vector<Change> changes;  ///< Each in the text that those before it have left.
    };
    void apply(std::size_t at, std::size_t removed, const std::string& inserted);
    void add(Step step);
    [[nodiscard]] bool goes_on(const Change& change) const;

    std::string text_, saved_;
    std::vector<Step> steps_;
    std::size_t done_ = 0;  ///< Steps before this one are in the text, others can be done again.
    bool typing_ = false;
    std::size_t changed_at_ = 0;
    std::vector<MergeConflict> conflicts_;
};

}  // namespace ui
