// What is under way while a program runs: the steps that a message about its end shows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csg/scad/machine/instruction.h"
#include "csg/scad/source/diagnostics.h"
#include "csg/scad/syntax/ast.h"
#include "csg/scad/value/value.h"

namespace csg::scad {

/// One step, on the native stack; they are linked from the inside out. Their texts are made only when an evaluation
/// fails: nobody pays for them otherwise.
struct ActiveStep {
    enum class Kind : std::uint8_t {
        CalledBy,   ///< A call; `name` is kNoSymbol for one that is not shown.
        CallOf,     ///< A user module whose body runs; with parameters.
        Assignment  ///< `assignment` indexes Program::assignments.
    };
    Kind kind = Kind::CalledBy;
    const SourceRange* where = nullptr;
    Symbol name = kNoSymbol;
    std::uint32_t assignment = 0;
    std::span<const Argument> parameters{};
    const Value* values = nullptr;    ///< Of the parameters.
    const Code* code = nullptr;       ///< Of an expression that runs.
    const Instruction* at = nullptr;  ///< The one of `code` that is under way; null before the first that matters.
    const ActiveStep* outer = nullptr;
};

/// As OpenSCAD shows them, the innermost first; of a long way only the first and the last `shown`, with a line for what
/// is left out.
[[nodiscard]] std::vector<Message> trace_messages(const Program& program, const ActiveStep* innermost,
                                                  std::size_t shown);

}  // namespace csg::scad
