// A file that is parsed by itself, once, and put wherever it is included. Inclusion is by tokens: a file may end in the
// middle of a statement. Of most libraries no file does; those are pieces, as long as there is nothing to say about
// them either. Whatever is odd is left to the parser that goes by tokens.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "csg/scad/source/source.h"
#include "csg/scad/syntax/ast.h"

namespace csg::scad {

/// Statements at the top level of a file with nothing else between them; as BlockBuilder takes them.
struct PieceStatements {
    std::vector<Argument> assignments;  ///< All of them, those to the same variable too.
    std::vector<FunctionDefinition> functions;
    std::vector<ModuleDefinition> modules;
    std::vector<Instantiation> instantiations;
    /// So many of the assignments are among the last two statements: the parser looks at what follows before it has
    /// done with them, so that messages about both come in another order.
    std::size_t last_assignments = 0;

    [[nodiscard]] bool empty() const {
        return assignments.empty() && functions.empty() && modules.empty() && instantiations.empty();
    }
};

/// One after another: statements, then perhaps an include or a use.
struct PieceStep {
    PieceStatements statements;
    enum class Then : std::uint8_t { Nothing, Include, Use } then = Then::Nothing;
    Symbol name = kNoSymbol;  ///< Of the file, as written.
    SourceRange where;        ///< Of the include or use.
};

/// Indices, symbols and the file (0) are the piece's own.
struct Piece {
    Program part;  ///< All that the statements consist of.
    std::vector<PieceStep> steps;
    SourceRange end;  ///< Where the text is at its end.
};

/// The file as a piece; null where it is none.
[[nodiscard]] std::shared_ptr<const Piece> make_piece(const SharedSource& file);

/// A copy of a piece's nodes in a program: what its indices are there.
class PlacedPiece {
  public:
    /// Adds the nodes to the program; `file`: the index of the source there.
    PlacedPiece(const Piece& piece, Program& program, std::uint32_t file);

    [[nodiscard]] Argument placed(Argument a) const;
    [[nodiscard]] FunctionDefinition placed(FunctionDefinition f) const;
    [[nodiscard]] ModuleDefinition placed(ModuleDefinition m) const;
    [[nodiscard]] Instantiation placed(Instantiation i) const;
    [[nodiscard]] Symbol placed(Symbol name) const { return name == kNoSymbol ? kNoSymbol : symbols_[name]; }
    [[nodiscard]] SourceRange placed(SourceRange where) const {
        where.file = file_;
        return where;
    }

  private:
    [[nodiscard]] static std::uint32_t moved(std::uint32_t index, std::uint32_t by) {
        return index == kNone ? kNone : index + by;
    }
    [[nodiscard]] static Run moved(Run run, std::uint32_t by) { return {run.first + by, run.count}; }
    [[nodiscard]] Expr placed(Expr e) const;
    [[nodiscard]] Block placed(Block b) const;
    void add_nodes(const Program& part, Program& program) const;
    void add_lazy(const LazyBodies& part, LazyBodies& lazy) const;

    std::uint32_t file_;
    std::uint32_t expressions_, elements_, arguments_, assignments_, functions_, modules_, instantiations_, blocks_,
        bodies_;  ///< How many there were before.
    std::vector<Symbol> symbols_;
};

}  // namespace csg::scad
