#include "csg/scad/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace csg::scad {

SourceRange spanning(const SourceRange& first, const SourceRange& last) {
    if (first.file != last.file || !last.known()) {
        return first;
    }
    return {first.file, first.line, first.column, last.end_line, last.end_column};
}

SourceFile::SourceFile(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
    line_starts_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i) {
        const bool ends = text_[i] == '\n' || (text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n'));
        if (ends) {
            line_starts_.push_back(i + 1);
        }
    }
}

std::string_view SourceFile::line(std::uint32_t line) const {
    if (line == 0 || line > line_starts_.size()) {
        return {};
    }
    const std::size_t begin = line_starts_[line - 1];
    std::size_t end = line < line_starts_.size() ? line_starts_[line] : text_.size();
    while (end > begin && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) {
        --end;
    }
    return std::string_view(text_).substr(begin, end - begin);
}

std::uint32_t SourceSet::add(SourceFile file) {
    files_.push_back(std::move(file));
    return static_cast<std::uint32_t>(files_.size() - 1);
}

ReadResult read_source_file(const std::string& path) {
    namespace fs = std::filesystem;
    const auto failed = [&](std::string_view why) {
        return ReadError{false, fmt::format("cannot read {}: {}", path, why)};
    };
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) {
        return ReadError{true, fmt::format("cannot read {}: no such file", path)};
    }
    if (error) {
        return failed(error.message());
    }
    if (status.type() == fs::file_type::directory) {
        return failed("it is a directory");
    }
    if (status.type() != fs::file_type::regular) {
        return failed("it is not a regular file");
    }
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        return failed(std::strerror(errno));
    }
    std::string text;
    std::string chunk(std::size_t{1} << 16, '\0');
    while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0) {
        text.append(chunk, 0, static_cast<std::size_t>(in.gcount()));
        if (text.size() > kMaxSourceBytes) {
            return failed(fmt::format("it is larger than {} MiB", kMaxSourceBytes >> 20));
        }
    }
    if (in.bad()) {
        return failed(std::strerror(errno));
    }
    return text;
}

std::vector<std::string> source_candidates(std::string_view name, std::string_view from,
                                           const std::vector<std::string>& search_path) {
    namespace fs = std::filesystem;
    const fs::path wanted(name);
    if (wanted.is_absolute()) {
        return {wanted.lexically_normal().string()};
    }
    std::vector<std::string> candidates{(fs::path(from).parent_path() / wanted).lexically_normal().string()};
    for (const std::string& directory : search_path) {
        candidates.push_back((fs::path(directory) / wanted).lexically_normal().string());
    }
    return candidates;
}

std::vector<std::string> search_path_from_environment() {
    std::vector<std::string> directories;
    const char* const variable = std::getenv("OPENSCADPATH");
    std::string_view rest = variable != nullptr ? variable : "";
    while (!rest.empty()) {
        const std::size_t colon = std::min(rest.find(':'), rest.size());
        if (colon > 0) {
            directories.emplace_back(rest.substr(0, colon));
        }
        rest.remove_prefix(std::min(colon + 1, rest.size()));
    }
    if (const char* const home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        directories.push_back(std::string(home) + "/.local/share/OpenSCAD/libraries");
    }
    for (const char* const prefix : {"/usr/local", "/usr"}) {
        directories.push_back(std::string(prefix) + "/share/openscad/libraries");
    }
    return directories;
}

}  // namespace csg::scad
