#include "csg/scad/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <mutex>
#include <system_error>

namespace csg::scad {

SourceRange spanning(const SourceRange& first, const SourceRange& last) {
    if (first.file != last.file || !last.known()) {
        return first;
    }
    return {first.file, first.line, first.column, last.end_line, last.end_column};
}

struct SourceFile::Lines {
    std::once_flag once;
    std::vector<std::size_t> starts{0};
};

SourceFile::SourceFile(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)), lines_(std::make_shared<Lines>()) {}

std::string_view SourceFile::line(std::uint32_t line) const {
    std::vector<std::size_t>& starts = lines_->starts;
    std::call_once(lines_->once, [&] {
        for (std::size_t i = 0; i < text_.size(); ++i) {
            if (text_[i] == '\n' || (text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n'))) {
                starts.push_back(i + 1);
            }
        }
    });
    if (line == 0 || line > starts.size()) {
        return {};
    }
    const std::size_t begin = starts[line - 1];
    std::size_t end = line < starts.size() ? starts[line] : text_.size();
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
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (file == nullptr) {
        return failed(std::strerror(errno));
    }
    std::setbuf(file.get(), nullptr);  // Pieces are large.
    std::string text;
    const std::uintmax_t size = fs::file_size(path, error);
    std::size_t piece = error || size > kMaxSourceBytes ? std::size_t{1} << 16 : static_cast<std::size_t>(size) + 1;
    for (std::size_t used = 0;; used = text.size(), piece = std::size_t{1} << 16) {
        text.resize(used + piece);
        const std::size_t got = std::fread(text.data() + used, 1, piece, file.get());
        text.resize(used + got);
        if (text.size() > kMaxSourceBytes) {
            return failed(fmt::format("it is larger than {} MiB", kMaxSourceBytes >> 20));
        }
        if (got < piece) {
            break;
        }
    }
    if (std::ferror(file.get()) != 0) {
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
