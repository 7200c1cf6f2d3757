// What expressions are compiled to: instructions for a machine whose registers hold values.
//
// The registers of a function are its parameters, in their order, then the variables of let and for inside it (where
// the resolver has put them), then temporaries. What a call passes is worked out where the registers of the called
// function will begin, so calls move nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csg/scad/syntax/ast.h"
#include "csg/scad/value/value.h"

namespace csg::scad {

using Register = std::uint32_t;

/// A register or a constant that an instruction reads.
enum class Operand : std::uint32_t {};

[[nodiscard]] constexpr Operand operand_of(Register r) {
    return Operand{2 * r};
}
[[nodiscard]] constexpr Operand constant_operand(std::uint32_t index) {
    return Operand{2 * index + 1};
}
[[nodiscard]] constexpr bool is_constant(Operand o) {
    return (static_cast<std::uint32_t>(o) & 1U) != 0;
}
[[nodiscard]] constexpr std::uint32_t index_of(Operand o) {
    return static_cast<std::uint32_t>(o) >> 1U;
}
/// As instructions hold it.
[[nodiscard]] constexpr std::uint32_t word(Operand o) {
    return static_cast<std::uint32_t>(o);
}

/// Where nothing else is said `a` and `b` are operands, and the result goes to the register `target`. Jumps go to the
/// instruction `target`.
enum class Opcode : std::uint8_t {
    Move,
    // Variables: `a` is an index of Resolution::variables. An unknown one gives undef and a warning.
    LoadVariable,
    LoadBlock,    ///< Of a frame: `b` hops outwards, slot `c`.
    LoadDynamic,  ///< `b`: dynamic index.
    LoadSilent,   ///< Without the warning.
    LoadCarried,  ///< Unset where it is unknown.
    CheckSet,     ///< Of the register `target`, which may be unset: undef and a warning then.
    // Operators.
    Unary,  ///< `flag`: the operator.
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    Binary,  ///< Any other; `flag`: the operator.
    Index,
    IndexBlock,  ///< Of a variable as LoadBlock reads it, by `b`; `flag` hops outwards, slot `c`.
    Member,      ///< `b`: symbol; `flag`: one more than the index of an element of a list, where it is a letter.
    Range,       ///< Registers `a`, `a` + 1, `a` + 2: begin, step, end.
    // Jumps; the conditional ones where what they ask is `flag`.
    Jump,
    JumpTrue,
    JumpEqual,
    JumpNotEqual,
    JumpLess,
    JumpLessEqual,
    JumpGreater,
    JumpGreaterEqual,
    JumpSet,  ///< Where the register `a` is set.
    // Lists.
    List,          ///< Takes `b` registers from `a` on.
    BeginList,     ///< `target` notes where the list that is gathered begins.
    Append,        ///< `a`
    AppendTaken,   ///< The register `a`, which is given up.
    AppendEach,    ///< What `a` consists of.
    AppendEachOf,  ///< What each element of the list `a` consists of.
    EndList,       ///< `a`: register of BeginList.
    // Loops: four registers from `a` on are theirs; `c`: the register of the variable. Jump past the end at once.
    ForValues,  ///< `b`: what to go through.
    ForRange,   ///< The registers hold begin, step and end; `b`: the expression of the loop.
    ForNext,    ///< Jumps back where there is a next one.
    ForRound,   ///< `a`: register that counts rounds.
    // Variables that are bound.
    BindDynamic,     ///< The `$` variable of index `target` to `a`.
    MarkDynamic,     ///< Notes in `target` which `$` variables hold.
    RestoreDynamic,  ///< Back to what `a` notes.
    Settle,          ///< Closures that wait for the register `a` get it.
    MakeClosure,
    WarnAssignment,  ///< Of one that binds nothing; `a`: the value, `b`: index of the argument.
    // Calls: `a` is an index of Resolution::calls. What `e` calls is worked out in registers from `b` on.
    Unset,         ///< The register `a`.
    CallFunction,  ///< The first `c` parameters have their argument; others may be unset.
    TailFunction,
    FindCallee,   ///< Into `b`; undef where it is no function value. Jumps where there is nothing to call.
    CheckCallee,  ///< That the register `b` holds a function; else jumps, with a warning.
    CallAny,      ///< Registers: callee as found, then `c` arguments as written. `a`: kNone for an expression.
    TailAny,
    CallBuiltin,     ///< `c` arguments.
    CallBuiltinOne,  ///< One argument: the operand `b`.
    Length,          ///< The same of len().
    WarnNoFunction,
    Echo,        ///< `b` registers from `a` on, for the arguments of `e`.
    FailAssert,  ///< `a`: the message, where `flag` is set.
    Return,      ///< `a`, which is given up.
};

struct Instruction {
    Opcode op = Opcode::Move;
    std::uint8_t flag = 0;
    std::uint32_t target = 0;
    std::uint32_t a = 0, b = 0, c = 0;
    ExprId e = kNone;  ///< What it was made from, for messages.
};

/// Instructions that work out the arguments of a call: if one fails, the call is under way too.
struct ArgumentRegion {
    std::uint32_t begin, end;
    ExprId call;
};

/// An expression of a statement, or a function.
struct Code {
    std::vector<Instruction> instructions;
    std::vector<Value> constants;
    std::vector<ArgumentRegion> arguments;  ///< Inner ones before those around them.
    std::vector<std::uint32_t> entries;     ///< Where to begin when so many of the first parameters are known.
    std::uint32_t registers = 0;
    std::span<const Argument> parameters;
    std::uint32_t first_parameter = 0;     ///< Their place among Program::arguments.
    std::uint32_t this_parameter = kNone;  ///< The one named `this` of a function value.
};

}  // namespace csg::scad
