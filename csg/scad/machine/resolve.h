// Finds out, before what it stands in runs, what each name in a program means: the slot of a variable, the definition
// of a function or module. Names that begin with `$` are dynamic and get an index instead.
//
// Variables live in two kinds of places. A *block* that declares something has a frame while its statements run, and
// frames nest as blocks do; they are reached by a number of hops outwards. Parameters of functions and the variables
// of let and for *inside expressions* are locals: slots of the activation of a function (or of the one expression of
// a statement). A function literal copies the locals it uses of its surroundings (captures) when it is made.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "csg/scad/builtin/builtin_functions.h"
#include "csg/scad/syntax/ast.h"
#include "csg/tree/tree.h"

namespace csg::scad {

struct ModuleContext;
/// Adds what the module makes to `out`: at most one node. See builtin_modules.h.
using BuiltinModule = void (*)(const ModuleContext& context, std::vector<NodeId>& out);

/// `Children`: $children, which is lexical although its name begins with `$`. `Pi`: the constant PI.
enum class Place : std::uint8_t { Unknown, Local, Capture, Block, Dynamic, Children, Pi };

struct VariableRef {
    Place place = Place::Unknown;
    std::uint32_t hops = 0;      ///< Block: frames outwards.
    std::uint32_t slot = 0;      ///< Or capture or dynamic index.
    std::uint32_t next = kNone;  ///< Index of the reference to try where this variable has no value yet.
};

inline constexpr std::uint32_t kUsedUnit = std::numeric_limits<std::uint32_t>::max();

/// A definition together with the frame it runs in: `hops` outwards from the caller, or, where `hops` is kUsedUnit,
/// the frame of `unit`.
struct DefinitionRef {
    std::uint32_t id = kNone;  ///< Index into Program::functions or ::modules.
    std::uint32_t hops = 0;
    UnitId unit = kNone;
};

/// What `name(…)` in an expression may call, the innermost first.
struct CallTarget {
    enum class Kind : std::uint8_t { Unknown, Variable, Function, Builtin } kind = Kind::Unknown;
    VariableRef variable;  ///< Called where it holds a function.
    DefinitionRef function;
    BuiltinFunction builtin = nullptr;
    std::string_view name{};     ///< Of the built-in.
    std::uint32_t next = kNone;  ///< Index of the target to try where the variable holds no function.
};

struct ModuleTarget {
    DefinitionRef user;               ///< id is kNone for a built-in or unknown module.
    BuiltinModule builtin = nullptr;  ///< Null for an unknown one.
};

/// Where a function literal takes a captured value from, when it is made.
struct CaptureSource {
    bool from_capture = false;  ///< Of the surrounding literal, else a local.
    bool late = false;          ///< A variable of a `let` that still is being worked out.
    std::uint32_t slot = 0;
};

struct LiteralInfo {
    std::vector<CaptureSource> captures;
    std::uint32_t locals = 0;
    std::uint32_t this_parameter = kNone;  ///< The one named `this`, which makes methods of objects.
};

/// A variable of a `for (…; …; …)` that begins with the value of one outside.
struct CarriedVariable {
    std::uint32_t slot = 0;
    std::uint32_t outer = kNone;  ///< Into Resolution::variables.
};

struct ModuleInfo {
    /// Named arguments that calls pass although they are no parameters, with their slots in the body's frame: the body
    /// sees them nevertheless.
    std::vector<std::pair<Symbol, std::uint32_t>> other_arguments;
    /// Assignments of the body (Program::assignments) that set a parameter to a literal.
    std::vector<std::uint32_t> literal_parameters;
};

/// Side tables of a Program; indexed as its arrays are.
struct Resolution {
    std::vector<std::uint32_t> of_expression;  ///< Identifier: into variables. Call of a name: into calls. Function:
                                               ///< into literals. Vector: 0 where its value is known beforehand.
                                               ///< ListForC: into carried.
    std::vector<VariableRef> variables;
    std::vector<CallTarget> calls;
    std::vector<LiteralInfo> literals;
    std::vector<std::vector<CarriedVariable>> carried;
    std::vector<std::uint32_t> argument_slots;    ///< Of arguments that declare: local, or dynamic index for `$` names.
    std::vector<bool> repeated_parameters;        ///< By argument: a parameter whose name one before it has.
    std::vector<std::uint32_t> assignment_slots;  ///< Frame slot, or dynamic index.
    std::vector<std::uint32_t> locals_of_function;
    std::vector<ModuleTarget> module_of_instantiation;
    std::vector<ModuleInfo> module_info;
    std::vector<std::uint32_t> frame_slots;        ///< Of blocks; kNone for a block without a frame.
    bool late_captures = false;                    ///< Whether any literal has one.
    std::uint32_t statement_locals = 0;            ///< The most that an expression of a statement needs.
    std::vector<std::uint32_t> dynamic_of_symbol;  ///< The index of a `$` name; kNone for other names.
    std::uint32_t dynamics = 0;                    ///< How many `$` names the program mentions.
};

/// A literal, or a sign of a number: its value is known beforehand.
[[nodiscard]] inline bool is_simple_literal(const Program& program, ExprId id) {
    const Expr& e = program[id];
    return is_literal_kind(e.kind) || (e.kind == ExprKind::Unary && program[e.operand(0)].kind == ExprKind::Number);
}

/// True for the modules whose arguments declare variables for their children: for, intersection_for, let, assign.
[[nodiscard]] bool declares_for_children(std::string_view module_name);

}  // namespace csg::scad
