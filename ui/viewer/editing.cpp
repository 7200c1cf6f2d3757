#include "ui/viewer/editing.h"

#include <stdexcept>
#include <string_view>
#include <system_error>

#include "base/file.h"

namespace ui {

namespace {

constexpr std::string_view kMark = "\xEF\xBB\xBF";
/// Seconds without a change before what is not saved is kept, and the longest that it waits.
constexpr double kQuiet = 0.3, kLongest = 1;

bool is_program(const std::filesystem::path& path) {
    return path.extension() == ".scad" || path.extension() == ".csg";
}

std::string absolute(const std::string& path) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(path, error).lexically_normal();
    return error ? path : whole.string();
}

}  // namespace

Editing::Editing(const Source& source, const std::filesystem::path& settings)
    : path_(absolute(source.followed())),
      recovery_(settings.empty() ? std::filesystem::path() : settings.parent_path() / "recovery", path_) {
    if (source.text || source.followed().empty() || !is_program(path_)) {
        return;
    }
    if (auto text = read()) {
        text_ = TextDocument(*std::move(text));
        possible_ = true;
        left_ = recovery_.left();
        if (left_ && left_->text == text_.text()) {
            recover(false);
        }
    }
}

std::optional<std::string> Editing::read() {
    auto bytes = base::read_regular_file(path_);
    if (bytes) {
        mark_ = bytes->starts_with(kMark) ? kMark : "";
        bytes->erase(0, mark_.size());
    }
    return bytes;
}

std::optional<std::string> Editing::unsaved_text() const {
    return text_.unsaved() ? std::optional(text_.text()) : std::nullopt;
}

TextDocument::FromDisk Editing::look_at_disk() {
    const auto text = possible_ ? read() : std::nullopt;
    return text ? text_.take_from_disk(*text) : TextDocument::FromDisk::Same;
}

std::string Editing::save() {
    if (!possible_) {
        return "There is no program that could be saved";
    }
    (void)look_at_disk();
    if (!text_.conflicts().empty()) {
        return "Not saved: the file has been changed in the same statements";
    }
    try {
        base::write_file(path_, mark_ + text_.text());
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    text_.set_saved();
    recovery_.drop();
    kept_.clear();
    return "";
}

void Editing::discard() {
    text_ = TextDocument(text_.saved_text());
    recovery_.drop();
    kept_.clear();
}

void Editing::keep(double now) {
    if (!possible_) {
        return;
    }
    if (!text_.unsaved()) {
        if (!kept_.empty()) {
            recovery_.drop();
            kept_.clear();
        }
        seen_ = text_.text();
        return;
    }
    if (seen_ != text_.text()) {
        since_ = seen_ == kept_ || seen_ == text_.saved_text() ? now : since_;
        seen_ = text_.text();
        seen_at_ = now;
    }
    if (kept_ != seen_ && (now - seen_at_ >= kQuiet || now - since_ >= kLongest)) {
        recovery_.keep(text_.saved_text(), text_.text());
        kept_ = seen_;
    }
}

void Editing::recover(bool take) {
    if (!left_) {
        return;
    }
    if (take) {
        // As if what is in the file had been written after it.
        const std::string now = text_.saved_text();
        text_ = TextDocument(left_->saved);
        text_.set_text(left_->text, "recover what was not saved");
        (void)text_.take_from_disk(now);
        recovery_.keep(text_.saved_text(), text_.text());
        kept_ = text_.text();
    }
    Recovery::forget(*left_);
    left_.reset();
}

}  // namespace ui
