#include "ui/pipeline/editing/text_document.h"

#include <algorithm>
#include <utility>

namespace ui {

void TextDocument::apply(std::size_t at, std::size_t removed, const std::string& inserted) {
    text_.replace(at, removed, inserted);
    changed_at_ = at + inserted.size();
    const auto moved = [&](std::size_t place, bool end) {
        if (place > at + removed || (place == at + removed && (removed > 0 || !end))) {
            return place + inserted.size() - removed;
        }
        return place > at ? (end ? at + inserted.size() : at) : place;
    };
    for (MergeConflict& conflict : conflicts_) {
        conflict.bytes = {moved(conflict.bytes.begin, false), moved(conflict.bytes.end, true)};
        conflict.bytes.end = std::max(conflict.bytes.begin, conflict.bytes.end);
    }
}

void TextDocument::add(Step step) {
    steps_.resize(done_);
    steps_.push_back(std::move(step));
    ++done_;
}

void TextDocument::edit(std::vector<TextEdit> edits, std::string what) {
    // From the end on, so that the places of those that are left hold.
    std::stable_sort(edits.begin(), edits.end(),
                     [](const TextEdit& a, const TextEdit& b) { return a.bytes.begin > b.bytes.begin; });
    Step step{std::move(what), {}};
    for (TextEdit& edit : edits) {
        const std::size_t length = edit.bytes.end - edit.bytes.begin;
        std::string removed = text_.substr(edit.bytes.begin, length);
        if (removed != edit.text) {
            apply(edit.bytes.begin, length, edit.text);
            step.changes.push_back({edit.bytes.begin, std::move(removed), std::move(edit.text)});
        }
    }
    typing_ = false;
    if (!step.changes.empty()) {
        add(std::move(step));
    }
}

bool TextDocument::goes_on(const Change& change) const {
    if (!typing_ || done_ == 0 || done_ != steps_.size()) {
        return false;
    }
    const Change& last = steps_.back().changes.back();
    const std::size_t end = last.at + last.inserted.size();
    return change.at == end || change.at + change.removed.size() == end;
}

void TextDocument::set_text(const std::string& text, std::string what, bool typing) {
    const std::size_t least = std::min(text.size(), text_.size());
    const auto from = static_cast<std::size_t>(
        std::mismatch(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(least), text_.begin()).first -
        text.begin());
    std::size_t tail = 0;
    while (tail < least - from && text[text.size() - 1 - tail] == text_[text_.size() - 1 - tail]) {
        ++tail;
    }
    Change change{from, text_.substr(from, text_.size() - tail - from), text.substr(from, text.size() - tail - from)};
    if (change.removed.empty() && change.inserted.empty()) {
        return;
    }
    const bool same_step = typing && goes_on(change);
    apply(change.at, change.removed.size(), change.inserted);
    if (same_step) {
        steps_.back().changes.push_back(std::move(change));
    } else {
        add({std::move(what), {std::move(change)}});
    }
    typing_ = typing;
}

bool TextDocument::undo() {
    typing_ = false;
    if (done_ == 0) {
        return false;
    }
    const std::vector<Change>& changes = steps_[--done_].changes;
    for (auto change = changes.rbegin(); change != changes.rend(); ++change) {
        apply(change->at, change->inserted.size(), change->removed);
    }
    return true;
}

bool TextDocument::redo() {
    typing_ = false;
    if (done_ == steps_.size()) {
        return false;
    }
    for (const Change& change : steps_[done_++].changes) {
        apply(change.at, change.removed.size(), change.inserted);
    }
    return true;
}

TextDocument::FromDisk TextDocument::take_from_disk(const std::string& text) {
    if (text == saved_) {
        return FromDisk::Same;
    }
    const bool mine = unsaved();
    Merged both = merged(saved_, text_, text);
    saved_ = text;
    typing_ = false;
    set_text(both.text, mine ? "merge with the file" : "change of the file");
    std::erase_if(conflicts_, [&](const MergeConflict& before) {  // It goes on as another.
        return std::any_of(both.conflicts.begin(), both.conflicts.end(), [&](const MergeConflict& now) {
            return std::max(now.bytes.begin, before.bytes.begin) < std::min(now.bytes.end, before.bytes.end);
        });
    });
    conflicts_.insert(conflicts_.end(), both.conflicts.begin(), both.conflicts.end());
    return !both.conflicts.empty() ? FromDisk::Conflict : mine ? FromDisk::Merged : FromDisk::Taken;
}

void TextDocument::resolve(std::size_t conflict, bool take_theirs) {
    const MergeConflict ended = conflicts_[conflict];
    conflicts_.erase(conflicts_.begin() + static_cast<std::ptrdiff_t>(conflict));
    if (take_theirs) {
        edit({{ended.bytes, ended.theirs}}, "take what is in the file");
    }
}

}  // namespace ui
