// What was under way when an evaluation ended.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "csg/scad/diagnostics.h"
#include "csg/scad/symbols.h"
#include "csg/scad/value.h"

namespace csg::scad {

/// One step outwards: where a call, a definition or an assignment stands. Its text is made only when it is shown,
/// because values may be long and recursion deep.
struct TraceStep {
    enum class Kind : std::uint8_t { CalledBy, CallOf, Assignment } kind = Kind::CalledBy;
    SourceRange where;
    Symbol name = kNoSymbol;
    std::vector<std::pair<Symbol, Value>> parameters;  ///< Of CallOf.
};

/// The steps, the innermost first; of a long way only the first and the last few.
class Trace {
  public:
    void add(TraceStep step);
    /// As OpenSCAD shows it; a line stands for what was left out.
    [[nodiscard]] std::vector<Message> messages(const SymbolTable& symbols) const;

  private:
    static constexpr std::size_t kEnd = 12;
    std::vector<TraceStep> first_;
    std::vector<TraceStep> last_;  ///< A ring once it is full.
    std::size_t count_ = 0;
};

}  // namespace csg::scad
