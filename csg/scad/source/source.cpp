#include "csg/scad/source/source.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>

#include "csg/scad/source/characters.h"
#include "csg/scad/source/paths.h"

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

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

SourceFile::SourceFile(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)), lines_(std::make_shared<Lines>()) {
    if (text_.starts_with(kByteOrderMark)) {
        text_.erase(0, kByteOrderMark.size());
        mark_bytes_ = kByteOrderMark.size();
    }
}

const std::vector<std::size_t>& SourceFile::line_starts() const {
    std::vector<std::size_t>& starts = lines_->starts;
    std::call_once(lines_->once, [&] {
        const char* const begin = text_.data();
        const char* const end = begin + text_.size();
        for (const char* at = end_of_line(begin, end); at != end; at = end_of_line(at, end)) {
            at += at[0] == '\r' && end - at > 1 && at[1] == '\n' ? 2 : 1;
            starts.push_back(static_cast<std::size_t>(at - begin));
        }
    });
    return starts;
}

std::string_view SourceFile::line(std::uint32_t line) const {
    const std::vector<std::size_t>& starts = line_starts();
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

std::size_t SourceFile::offset(std::uint32_t line, std::uint32_t column) const {
    const std::vector<std::size_t>& starts = line_starts();
    if (line == 0 || column == 0 || line > starts.size()) {
        return line == 0 || column == 0 ? 0 : text_.size();
    }
    return std::min(starts[line - 1] + (column - 1), text_.size());
}

SourceLocation SourceFile::place(std::size_t offset) const {
    const std::vector<std::size_t>& starts = line_starts();
    const std::size_t at = std::min(offset, text_.size());
    const auto next = std::upper_bound(starts.begin(), starts.end(), at);
    const std::size_t begin = *std::prev(next);
    return {0, static_cast<std::uint32_t>(next - starts.begin()), static_cast<std::uint32_t>(at - begin) + 1};
}

std::uint32_t SourceSet::add(SharedSource file) {
    files_.push_back(std::move(file));
    return static_cast<std::uint32_t>(files_.size() - 1);
}

ByteRange SourceSet::bytes_of(const SourceRange& range) const {
    const SourceFile& file = *files_[range.file];
    return {file.offset(range.line, range.column), file.offset(range.end_line, range.end_column)};
}

namespace {

/// A file that is open for reading, or was to be.
class InputFile {
  public:
    /// Does not wait for who might write into a pipe of that name.
    explicit InputFile(const std::string& path) : descriptor_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
    ~InputFile() {
        if (descriptor_ >= 0) {
            close(descriptor_);
        }
    }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
    [[nodiscard]] bool status(struct stat& result) const { return fstat(descriptor_, &result) == 0; }
    /// Appends up to `most` bytes to `text`. False where reading fails; nothing is appended at the end of the file.
    [[nodiscard]] bool read_into(std::string& text, std::size_t most) const {
        const std::size_t used = text.size();
        text.reserve(used + most);
        populate(text.data() + used, most);
        text.resize(used + most);
        ssize_t got = 0;
        do {
            got = read(descriptor_, text.data() + used, most);
        } while (got < 0 && errno == EINTR);
        text.resize(used + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        return got >= 0;
    }

  private:
    /// Has the kernel give the pages of a large buffer at once: one by one, that takes longer than reading into them.
    static void populate(char* data, std::size_t size) {
#ifdef MADV_POPULATE_WRITE
        constexpr std::uintptr_t kPage = 4096;
        const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(data) + kPage - 1) & ~(kPage - 1);
        const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(data) + size) & ~(kPage - 1);
        if (end > begin + 4 * kPage) {
            (void)madvise(data + (begin - reinterpret_cast<std::uintptr_t>(data)), end - begin,
                          MADV_POPULATE_WRITE);  // If it can.
        }
#else
        (void)data, (void)size;
#endif
    }

    int descriptor_;
};

}  // namespace

ReadResult read_source_file(const std::string& path) {
    const auto failed = [&](std::string_view why) {
        return ReadError{false, fmt::format("cannot read {}: {}", path, why)};
    };
    const InputFile file(path);
    if (!file.is_open()) {
        const bool missing = errno == ENOENT || errno == ENOTDIR;
        return missing ? ReadError{true, fmt::format("cannot read {}: no such file", path)}
                       : failed(std::strerror(errno));
    }
    struct stat status {};
    if (!file.status(status)) {
        return failed(std::strerror(errno));
    }
    if (S_ISDIR(status.st_mode)) {
        return failed("it is a directory");
    }
    if (!S_ISREG(status.st_mode)) {
        return failed("it is not a regular file");
    }
    std::string text;
    const auto size = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
    for (std::size_t piece = std::min(size, kMaxSourceBytes) + 1;; piece = std::size_t{1} << 16) {
        const std::size_t used = text.size();
        if (!file.read_into(text, piece)) {
            return failed(std::strerror(errno));
        }
        if (text.size() > kMaxSourceBytes) {
            return failed(fmt::format("it is larger than {} MiB", kMaxSourceBytes >> 20));
        }
        if (text.size() == used || text.size() == size) {  // At its end, if it has not grown since.
            return text;
        }
    }
}

std::optional<std::string> source_candidate(std::size_t index, std::string_view name, std::string_view from,
                                            std::span<const std::string> search_path) {
    if (index == 0) {
        return normal_path(path_in(folder_of_path(from), name));
    }
    if (index > search_path.size() || name.starts_with('/')) {
        return std::nullopt;
    }
    return normal_path(path_in(search_path[index - 1], name));
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
