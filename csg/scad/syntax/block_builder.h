// Gathers what a block declares while it is parsed. Internal to the parser.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "csg/scad/syntax/ast.h"
#include "csg/scad/syntax/piece.h"

namespace csg::scad {

class BlockBuilder {
  public:
    /// Where the variable was assigned before; the first place and the last value stay.
    std::optional<SourceRange> assign(const Argument& assignment);
    /// From now on all assignments are kept as they come, for take().
    void keep_all() { keep_all_ = true; }
    [[nodiscard]] std::size_t assignment_count() const { return assignments_.size(); }
    [[nodiscard]] PieceStatements take();
    void add(const FunctionDefinition& f) { functions_.push_back(f); }
    void add(const ModuleDefinition& m) { modules_.push_back(m); }
    void add(const Instantiation& i) { instantiations_.push_back(i); }
    /// Appends all of it to the program. Blocks inside this one must be finished before.
    [[nodiscard]] BlockId finish(Program& program);

  private:
    bool keep_all_ = false;
    std::vector<Argument> assignments_;
    std::vector<FunctionDefinition> functions_;
    std::vector<ModuleDefinition> modules_;
    std::vector<Instantiation> instantiations_;
    std::unordered_map<Symbol, std::size_t> places_;            ///< Of assignments.
    std::unordered_map<std::size_t, SourceRange> overwritten_;  ///< By assignment: where it stood first.
};

/// Moves the elements of `from` that begin at `mark` to the end of `to`.
template <typename T>
Run append_run(FlatArray<T>& to, std::vector<T>& from, std::size_t mark) {
    const Run run{static_cast<std::uint32_t>(to.size()), static_cast<std::uint32_t>(from.size() - mark)};
    to.append(from.begin() + static_cast<std::ptrdiff_t>(mark), from.end());
    from.resize(mark);
    return run;
}

}  // namespace csg::scad
