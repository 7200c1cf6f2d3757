// The files of a program while it is parsed: found, read once, and handed out. Internal to the parser.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "csg/scad/source/diagnostics.h"
#include "csg/scad/syntax/ast.h"
#include "csg/scad/syntax/parser.h"

namespace csg::scad {

inline constexpr std::size_t kMaxIncludeDepth = 100;
inline constexpr std::size_t kMaxInclusions = 10'000;  ///< In one program; files may include each other in circles.

class Files {
  public:
    /// All three must outlive it. Adds the main file and its unit.
    Files(const ParseRequest& request, Program& program, const MessageSink& sink);

    /// The file that `include <name>` in the file `from` means; nothing (and a warning) where there is none. A file
    /// in `open` is already being included: it is passed over, as in OpenSCAD, so circles end.
    std::optional<std::uint32_t> include(const std::string& name, std::uint32_t from,
                                         std::span<const std::uint32_t> open, const SourceRange& where);
    /// Notes a `use <name>` in the file `from` for `unit`; the used file becomes a unit to be parsed later.
    void use(const std::string& name, std::uint32_t from, UnitId unit, const SourceRange& where);

    /// The file as a piece; null where it is to be read token by token.
    [[nodiscard]] std::shared_ptr<const Piece> piece(std::uint32_t file) const {
        return request_.piece_of ? request_.piece_of(program_.sources.shared(file)) : nullptr;
    }

    /// Counts what inclusions cost. False where the program has become too large.
    [[nodiscard]] bool account(std::uint32_t file);

    [[nodiscard]] Program& program() { return program_; }
    [[nodiscard]] const MessageSink& sink() const { return sink_; }
    /// Relative to the directory of the main file, where it is inside it.
    [[nodiscard]] std::string name_in_messages(std::uint32_t file) const;

  private:
    [[nodiscard]] SourceResult read(const std::string& path) const;
    struct Found {
        std::optional<std::uint32_t> file;
        std::string path;
        std::string problem;  ///< Why a file that is there could not be read.
    };
    Found find(const std::string& name, std::uint32_t from, std::span<const std::uint32_t> open);
    /// Paths in the order in which they are tried; nothing beyond the last.
    using Candidates = std::function<std::optional<std::string>(std::size_t index)>;
    Found find_existing(const Candidates& candidates, std::span<const std::uint32_t> open);
    [[nodiscard]] bool any_open(const Candidates& candidates, std::span<const std::uint32_t> open) const;
    [[nodiscard]] std::string identity(const std::string& path) const;

    const ParseRequest& request_;
    Program& program_;
    const MessageSink& sink_;
    std::string working_directory_;
    std::string base_directory_;  ///< Of the main file, with a slash at its end; empty for the working directory.
    std::unordered_map<std::string, std::uint32_t> by_path_;  ///< By `identity`.
    std::unordered_map<std::uint32_t, UnitId> unit_of_file_;
    std::size_t inclusions_ = 0;
    std::size_t bytes_ = 0;
};

}  // namespace csg::scad
