#include "csg/scad/source/source_store.h"

#include <algorithm>
#include <ctime>

namespace csg::scad {

namespace {

/// Times of files may be as coarse as two seconds: what was written as short a time before it was read may have been
/// written again since without a trace.
constexpr std::int64_t kCoarsestTime = 2;

bool is_settled(const DiskState& state) {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    return std::max(state.seconds, state.changed_seconds) + kCoarsestTime < now.tv_sec;
}

bool reads_disk(const SourceReader& reader) {
    const auto* const function = reader.target<ReadResult (*)(const std::string&)>();
    return function != nullptr && *function == &read_source_file;
}

/// The length of what a file that was read held, with its byte order mark.
bool has_text(const SourceFile& file, const std::string& text) {
    return file.mark_bytes() + file.text().size() == text.size() &&
           text.compare(file.mark_bytes(), std::string::npos, file.text()) == 0;
}

}  // namespace

bool same_source(const SourceResult& a, const SourceResult& b) {
    if (a.index() != b.index()) {
        return false;
    }
    if (const auto* file = std::get_if<SharedSource>(&a)) {
        return *file == std::get<SharedSource>(b);
    }
    const auto& x = std::get<ReadError>(a);
    const auto& y = std::get<ReadError>(b);
    return x.missing == y.missing && x.text == y.text;
}

const SourceStore::Answer* SourceStore::known(const std::string& path, const DiskState& state) {
    const auto found = entries_.find(path);
    if (found == entries_.end()) {
        return nullptr;
    }
    found->second.used = round_;
    const Entry& entry = found->second;
    const bool text = std::holds_alternative<SharedSource>(entry.answer.result);
    return text && entry.settled && entry.answer.state == state ? &entry.answer : nullptr;
}

SourceStore::Answer SourceStore::read(const std::string& path, const SourceReader& reader) {
    std::optional<DiskState> state;
    if (reads_disk(reader)) {
        state = disk_state(path);  // Before it is read: a change in between is a change.
        const std::scoped_lock lock(mutex_);
        if (const Answer* const answer = known(path, *state)) {
            return *answer;
        }
    }
    const bool settled = state && state->exists && is_settled(*state);
    ReadResult read = reader(path);
    const std::scoped_lock lock(mutex_);
    Entry& entry = entries_[path];
    entry.answer.state = state;
    entry.settled = settled;
    entry.used = round_;
    if (auto* const text = std::get_if<std::string>(&read)) {
        const auto* const before = std::get_if<SharedSource>(&entry.answer.result);
        if (before == nullptr || *before == nullptr || !has_text(**before, *text)) {
            entry.answer.result = std::make_shared<const SourceFile>(path, std::move(*text));
        }
    } else {
        entry.answer.result = std::get<ReadError>(std::move(read));
    }
    return entry.answer;
}

void SourceStore::trim() {
    const std::scoped_lock lock(mutex_);
    ++round_;
    std::erase_if(entries_, [this](const auto& entry) { return round_ - entry.second.used > kKept; });
}

}  // namespace csg::scad
