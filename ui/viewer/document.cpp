#include "ui/viewer/document.h"

#include <filesystem>

#include <fmt/format.h>

namespace ui {

void Document::receive(Revision revision) {
    received_ = true;
    canceled_ = false;
    failed_ = !revision.model;
    if (revision.model) {
        model_ = std::move(revision.model);
        model_sources_ = revision.sources;
        tree_ = std::move(revision.tree);
        before_ = std::move(revision.before);
        first_tree_ = first_tree_ ? first_tree_ : tree_;
        view_ = revision.view;
        glyphs_ = {std::move(revision.depicted), std::move(revision.depiction_problems), std::move(revision.bubbles),
                   std::move(revision.frames), std::move(revision.styles)};
    }
    sources_ = std::move(revision.sources);
    messages_ = std::move(revision.messages);
    first_error_ = messages_.first_error();
    milliseconds_ = revision.evaluate_ms + revision.build_ms;
}

void Document::hide(const CallAt& call, bool hidden) {
    std::erase(source_.hidden, call);
    if (hidden) {
        source_.hidden.push_back(call);
    }
}

std::string Document::file_name() const {
    return source_.path == "-" ? "standard input" : std::filesystem::path(source_.path).filename().string();
}

DocumentState Document::state() const {
    if (gone_) {
        return DocumentState::Gone;
    }
    if (source_.nothing()) {
        return DocumentState::Good;
    }
    if (!received_) {
        return DocumentState::Evaluating;
    }
    return failed_ ? DocumentState::Failed : DocumentState::Good;
}

std::string Document::trouble() const {
    const char* const kept = model_ ? "The last good model is shown." : "There is nothing to show yet.";
    switch (state()) {
        case DocumentState::Gone:
            return fmt::format("{} is gone. {}", file_name(), kept);
        case DocumentState::Failed:
            return fmt::format("{}\n{}", first_error_.empty() ? "The file has errors" : first_error_, kept);
        case DocumentState::Evaluating:
        case DocumentState::Good:
            break;
    }
    if (canceled_) {
        return fmt::format("Canceled: F5 begins anew. {}", kept);
    }
    return {};
}

}  // namespace ui
