// Source texts: where they come from and where their lines begin.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "csg/tree/source_location.h"

namespace csg::scad {

/// A half-open range of source text. Columns count bytes from 1, as lines do; `end_column` is one past the last byte.
/// line 0 means "no place".
struct SourceRange {
    std::uint32_t file = 0;  ///< Index into SourceSet.
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::uint32_t end_line = 0;
    std::uint32_t end_column = 0;

    [[nodiscard]] SourceLocation begin() const { return {file, line, column}; }
    [[nodiscard]] bool known() const { return line != 0; }
    bool operator==(const SourceRange&) const = default;
};

/// From the start of `first` to the end of `last`; just `first` where they lie in different files (an include).
[[nodiscard]] SourceRange spanning(const SourceRange& first, const SourceRange& last);

/// One text, immutable. Lines end with \n, \r\n or \r.
class SourceFile {
  public:
    /// A byte order mark at the beginning of the text is left out.
    SourceFile(std::string name, std::string text);

    [[nodiscard]] const std::string& name() const { return name_; }  ///< The path as it was found, or a made-up name.
    [[nodiscard]] const std::string& text() const { return text_; }
    /// Without its line end. `line` counts from 1; empty outside the file.
    [[nodiscard]] std::string_view line(std::uint32_t line) const;
    /// Of the byte that stands there, in text(); the end of the text at most. `line` and `column` count from 1.
    [[nodiscard]] std::size_t offset(std::uint32_t line, std::uint32_t column) const;
    /// Where that byte stands, as SourceRange counts; of the end of the text at most.
    [[nodiscard]] SourceLocation place(std::size_t offset) const;  ///< Its `file` is 0.
    /// How many bytes of the file precede text(): those of a byte order mark.
    [[nodiscard]] std::size_t mark_bytes() const { return mark_bytes_; }

  private:
    struct Lines;
    [[nodiscard]] const std::vector<std::size_t>& line_starts() const;
    std::string name_;
    std::string text_;
    std::size_t mark_bytes_ = 0;
    std::shared_ptr<Lines> lines_;  ///< Where they begin, once somebody has asked: most texts are never shown.
};

/// A half-open range of bytes of a text.
struct ByteRange {
    std::size_t begin = 0, end = 0;
    bool operator==(const ByteRange&) const = default;
};

/// All texts of a program; a file's index is its SourceLocation::file. A file that is included twice is listed once.
/// Copies share the texts.
class SourceSet {
  public:
    std::uint32_t add(SourceFile file) { return add(std::make_shared<const SourceFile>(std::move(file))); }
    std::uint32_t add(std::shared_ptr<const SourceFile> file);
    /// Another text takes the place of `file`.
    void replace(std::uint32_t file, SourceFile by) {
        files_[file] = std::make_shared<const SourceFile>(std::move(by));
    }
    [[nodiscard]] const SourceFile& operator[](std::uint32_t file) const { return *files_[file]; }
    [[nodiscard]] std::size_t size() const { return files_.size(); }
    [[nodiscard]] const std::shared_ptr<const SourceFile>& shared(std::uint32_t file) const { return files_[file]; }
    /// Of a known range, in its file's text.
    [[nodiscard]] ByteRange bytes_of(const SourceRange& range) const;

  private:
    std::vector<std::shared_ptr<const SourceFile>> files_;
};

inline constexpr std::size_t kMaxSourceBytes = std::size_t{64} << 20;

/// Why a text could not be had. `missing` tells "no such file" (the search goes on) from a file that failed.
struct ReadError {
    bool missing = false;
    std::string text;  ///< For people: "cannot read …: reason".
};

using ReadResult = std::variant<std::string, ReadError>;

/// A file that is shared by all who read it.
using SharedSource = std::shared_ptr<const SourceFile>;
using SourceResult = std::variant<SharedSource, ReadError>;

/// Gives the text of a path. Tests, standard input and the viewer put their own in place of `read_source_file`.
using SourceReader = std::function<ReadResult(const std::string& path)>;

/// Makes the file of a path that is missing, if it can.
using FileMaker = std::function<void(const std::string& path)>;

/// Reads a regular file from disk; a directory, an unreadable file or one above kMaxSourceBytes is an error.
[[nodiscard]] ReadResult read_source_file(const std::string& path);

/// Where `name`, written in an include or use of the file `from`, is looked for: the path that is tried first, second,
/// …
/// (`index` counts from 0), as long as there are more. As it is when absolute; else beside `from`, then in each of
/// `search_path`. Paths are normalized lexically ("a/../b" is "b").
[[nodiscard]] std::optional<std::string> source_candidate(std::size_t index, std::string_view name,
                                                          std::string_view from,
                                                          std::span<const std::string> search_path);

/// Directories of the environment variable OPENSCADPATH (separated by ':'), then OpenSCAD's own library folders: the
/// user's and those of the system. They need not exist.
[[nodiscard]] std::vector<std::string> search_path_from_environment();

}  // namespace csg::scad
