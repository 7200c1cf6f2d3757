#include "csg/scad/program/program_cache.h"

#include <algorithm>
#include <map>
#include <new>

#include "csg/scad/program/deep_thread.h"
#include "csg/scad/program/loading.h"

namespace csg::scad {

namespace {

/// What tells one program from another but what its files hold.
struct Key {
    std::string path;
    bool given_text;
    std::vector<std::string> search_path;
    bool makes_missing;
    std::vector<std::string> definitions;  ///< Where they may name files; else any will do.
    bool operator==(const Key&) const = default;
};

Key key_of(const Request& r) {
    return {r.path, r.text.has_value(), r.search_path, static_cast<bool>(r.make_missing),
            may_name_files(r.definitions) ? r.definitions : std::vector<std::string>()};
}

bool same_text(const SourceFile& a, const SourceFile& b) {
    return &a == &b || (a.mark_bytes() == b.mark_bytes() && a.text() == b.text());
}

}  // namespace

struct ProgramCache::Entry {
    Key key;
    SharedSource main;
    ReadLog log;
    std::shared_ptr<LoadedProgram> program;
};

ProgramCache::ProgramCache() = default;
ProgramCache::~ProgramCache() = default;

ProgramCache::Counts ProgramCache::counts() const {
    const std::scoped_lock lock(mutex_);
    return {counts_.parsed, counts_.kept, pieces_.made()};
}

ProgramCache::Found ProgramCache::find(const Request& request, std::vector<Message>& messages) {
    const std::scoped_lock lock(mutex_);
    sources_.trim();
    pieces_.trim();
    Loading loading(request, &sources_, &pieces_);
    const SourceResult main = loading.main();
    const auto looked_for = [&loading] {
        std::vector<std::pair<std::string, DiskState>> all;
        for (const ReadLog::Step& step : loading.log().steps) {
            if (step.state) {
                all.emplace_back(step.path, *step.state);
            }
        }
        return all;
    };
    if (const auto* const error = std::get_if<ReadError>(&main)) {
        messages.push_back({Severity::Error, {}, error->text});
        return {nullptr, looked_for()};
    }
    const SharedSource& source = std::get<SharedSource>(main);
    Key key = key_of(request);
    auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.key == key; });
    if (entry == entries_.end()) {
        entry = entries_.insert(entries_.begin(), Entry{std::move(key), nullptr, {}, nullptr});
    } else {
        entries_.splice(entries_.begin(), entries_, entry);
    }
    const bool kept = entry->program != nullptr && same_text(*entry->main, *source) && loading.repeats(entry->log) &&
                      entry->program->can_define(request.definitions) && !entry->program->spent();
    if (kept) {
        ++counts_.kept;
    } else {
        ++counts_.parsed;
        entry->program = nullptr;  // Should parsing run out of memory.
        entry->program = std::make_shared<LoadedProgram>(loading.parse(source), request.definitions);
        entry->main = source;
    }
    entry->log = loading.log();
    if (entries_.size() > kMostPrograms) {
        entries_.pop_back();
    }
    return {entry->program, looked_for()};
}

std::shared_ptr<LoadedProgram> ProgramCache::load(const Request& request, const EvaluationSink& sink) {
    std::vector<Message> messages;
    Found found = find(request, messages);
    for (const Message& message : messages) {
        if (sink) {
            sink(message, SourceSet());
        }
    }
    if (found.program != nullptr) {
        found.program->define(request.definitions);
    }
    return found.program;
}

Evaluation ProgramCache::evaluate(const Request& request, const EvaluationSink& sink) {
    return evaluate_with(request, sink, false, [&](Evaluation& result, std::vector<Message>& messages) {
        Found found = find(request, messages);
        result.looked_for = std::move(found.looked_for);
        return found.program;
    });
}

}  // namespace csg::scad
