#include "csg/scad/syntax/parser_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "csg/scad/source/paths.h"

namespace csg::scad {
namespace {

bool is_font(std::string_view name) {
    if (name.size() < 4) {
        return false;
    }
    std::string end(name.substr(name.size() - 4));
    std::transform(end.begin(), end.end(), end.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return end == ".ttf" || end == ".otf";
}

}  // namespace

Files::Files(const ParseRequest& request, Program& program, const MessageSink& sink)
    : request_(request), program_(program), sink_(sink) {
    std::error_code error;
    working_directory_ = std::filesystem::current_path(error).string();
    const std::uint32_t main = program.sources.add(
        request.main != nullptr ? request.main : std::make_shared<const SourceFile>(request.path, request.text));
    by_path_.emplace(identity(request.path), main);
    base_directory_ = folder_of_path(normal_path(request.path));
    base_directory_ += base_directory_.empty() || base_directory_.ends_with('/') ? "" : "/";
    unit_of_file_.emplace(main, 0);
    program.units.push_back({main, kNone, {}});
}

/// Equal for paths that name the same file, as far as their text tells.
std::string Files::identity(const std::string& path) const {
    return normal_path(path_in(working_directory_, path));
}

SourceResult Files::read(const std::string& path) const {
    if (request_.find) {
        return request_.find(path);
    }
    ReadResult result = request_.reader(path);
    if (auto* const text = std::get_if<std::string>(&result)) {
        return std::make_shared<const SourceFile>(path, std::move(*text));
    }
    return std::get<ReadError>(std::move(result));
}

Files::Found Files::find(const std::string& name, std::uint32_t from, std::span<const std::uint32_t> open) {
    if (name.empty() || name.ends_with('/')) {  // Names a directory at best.
        return {};
    }
    const Candidates candidates = [&](std::size_t index) {
        return source_candidate(index, name, program_.sources[from].name(), request_.search_path);
    };
    Found found = find_existing(candidates, open);
    if (!found.file && found.problem.empty() && request_.make_missing && !any_open(candidates, open)) {
        request_.make_missing(*candidates(0));
        found = find_existing(candidates, open);
    }
    return found;
}

bool Files::any_open(const Candidates& candidates, std::span<const std::uint32_t> open) const {
    for (std::size_t i = 0; const std::optional<std::string> path = candidates(i); ++i) {
        const auto known = by_path_.find(identity(*path));
        if (known != by_path_.end() && std::find(open.begin(), open.end(), known->second) != open.end()) {
            return true;
        }
    }
    return false;
}

Files::Found Files::find_existing(const Candidates& candidates, std::span<const std::uint32_t> open) {
    Found found;
    for (std::size_t i = 0; const std::optional<std::string> path = candidates(i); ++i) {
        std::string key = identity(*path);
        if (const auto known = by_path_.find(key); known != by_path_.end()) {
            if (std::find(open.begin(), open.end(), known->second) != open.end()) {
                continue;
            }
            return {known->second, *path, {}};
        }
        SourceResult result = read(*path);
        if (auto* const source = std::get_if<SharedSource>(&result)) {
            const std::uint32_t file = program_.sources.add(std::move(*source));
            by_path_.emplace(std::move(key), file);
            return {file, *path, {}};
        }
        const ReadError& error = std::get<ReadError>(result);
        if (!error.missing && found.problem.empty()) {
            found.problem = error.text;
        }
    }
    return found;
}

std::optional<std::uint32_t> Files::include(const std::string& name, std::uint32_t from,
                                            std::span<const std::uint32_t> open, const SourceRange& where) {
    const Found found = find(name, from, open);
    if (!found.file) {
        report(sink_, {Severity::Warning, where,
                       found.problem.empty() ? fmt::format("Can't find include file '{}'.", name)
                                             : fmt::format("Can't open include file '{}': {}", name, found.problem),
                       true});
    }
    return found.file;
}

void Files::use(const std::string& name, std::uint32_t from, UnitId unit, const SourceRange& where) {
    const Found found = find(name, from, {});
    Use use{found.file ? found.path : name, kNone, is_font(name), where};
    if (!found.file) {
        report(sink_, {Severity::Warning, where,
                       found.problem.empty() ? fmt::format("Can't open library '{}'.", name)
                                             : fmt::format("Can't open library '{}': {}", name, found.problem),
                       true});
    } else if (!use.font) {
        const auto [at, is_new] = unit_of_file_.emplace(*found.file, static_cast<UnitId>(program_.units.size()));
        use.unit = at->second;
        if (is_new) {
            program_.units.push_back({*found.file, kNone, {}});
        }
    }
    std::vector<Use>& uses = program_.units[unit].uses;
    if (std::none_of(uses.begin(), uses.end(), [&](const Use& u) { return u.path == use.path; })) {
        uses.push_back(std::move(use));
    }
}

std::string Files::name_in_messages(std::uint32_t file) const {
    std::string name = normal_path(program_.sources[file].name());
    name.erase(0, name.starts_with(base_directory_) ? base_directory_.size() : 0);
    return name;
}

bool Files::account(std::uint32_t file) {
    bytes_ += program_.sources[file].text().size();
    return ++inclusions_ <= kMaxInclusions && bytes_ <= kMaxSourceBytes;
}

}  // namespace csg::scad
