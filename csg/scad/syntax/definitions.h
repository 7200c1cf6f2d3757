// Assignments from outside (-D, parameter sets) that come after those of the main file, and that others may replace
// without the program being parsed again.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "csg/scad/source/diagnostics.h"
#include "csg/scad/syntax/ast.h"

namespace csg::scad {

class Files;

/// The made-up name of the text that holds the definitions.
inline constexpr std::string_view kCommandLine = "<command line>";

/// Whether one of the texts may name files, by include or use: only the parser of a whole program reads such.
[[nodiscard]] bool may_name_files(std::span<const std::string> definitions);

/// What was defined last; of one program.
class Definitions {
  public:
    Definitions() = default;
    /// None yet. The main file's block has just been parsed.
    explicit Definitions(const Program& program);

    /// The definitions from now on, each name=expression, more of them after semicolons: they count as if they stood
    /// behind the main file. False where there is a syntax error, which is one message; then there are none. Adds nodes
    /// to the program. `files`: where they may name files; null else.
    bool set(Program& program, std::span<const std::string> texts, const MessageSink& sink, Files* files = nullptr);

    /// Names that the main file does not assign, sorted.
    [[nodiscard]] const std::vector<Symbol>& other_names() const { return other_names_; }
    /// The values that were parsed last.
    [[nodiscard]] const std::vector<ExprId>& values() const { return values_; }

  private:
    struct Merged {
        std::vector<Argument> assignments;
        std::vector<std::pair<std::size_t, SourceRange>> first_places;  ///< Of those that were written more than once.
    };
    void reset(Program& program);
    [[nodiscard]] Merged merge(const Program& program, std::span<const Argument> definitions);
    void enter(Program& program, const Merged& merged);
    [[nodiscard]] std::uint32_t source(Program& program, std::size_t index, const std::string& text);

    Run base_{};                        ///< The assignments of the main file's block without any definitions.
    Run overlay_{};                     ///< The last that took their place.
    std::vector<std::uint32_t> files_;  ///< Of the program's sources, those for texts of definitions.
    std::vector<Symbol> other_names_;
    std::vector<ExprId> values_;
};

}  // namespace csg::scad
