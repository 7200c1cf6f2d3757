// The syntax tree: flat arrays of nodes that refer to each other by index.
//
// Everything a model consists of (the main file, what it includes, and the files it uses) is one Program. Nodes are
// never moved or changed after parsing, so side tables indexed by ExprId, BlockId, … may hold what an evaluator finds
// out about them (slots, constants). Children are made before their parents: a child's index is smaller. Bodies of
// definitions may be built later (LazyBodies): room is kept for them, so that nothing moves then either.
//
// Depth: the parser bounds nesting by kMaxNesting, except for chains that grow without brackets. Walk those in a loop:
// operand(0) of Binary, Call, Index and Member ("a+b+c+…", "f()()…"), operand(2) of Conditional ("a?b:c?d:…") and
// `otherwise` of Instantiation ("if … else if …").
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "csg/scad/source/flat_array.h"
#include "csg/scad/source/source.h"
#include "csg/scad/syntax/lazy_body.h"
#include "csg/scad/value/symbols.h"

namespace csg::scad {

using ExprId = std::uint32_t;
using BlockId = std::uint32_t;
using UnitId = std::uint32_t;
inline constexpr std::uint32_t kNone = ~std::uint32_t{0};  ///< No expression, block or unit.

/// How deep brackets, blocks, prefix operators and the like may nest.
inline constexpr int kMaxNesting = 1000;

/// A run of one of Program's arrays; which one, the user's comment says.
struct Run {
    std::uint32_t first;
    std::uint32_t count;
};

/// What the fields of Expr hold for each kind; fields not named mean nothing.
enum class ExprKind : std::uint8_t {
    Undef,
    Boolean,      ///< number: 0 or 1
    Number,       ///< number
    String,       ///< name: the text, escapes resolved
    Identifier,   ///< name (with its `$`, if any)
    Vector,       ///< elements; those of kinds ListFor … ListEach give any number of values
    Range,        ///< operands: begin, step (kNone where not written), end
    Unary,        ///< op; operands: operand
    Binary,       ///< op; operands: left, right
    Conditional,  ///< operands: condition, then, else
    Call,         ///< operands: callee (an Identifier calls a function or a function value of that name); arguments
    Index,        ///< operands: value, index
    Member,       ///< operands: value; name: what stands after the dot
    Let,          ///< arguments (assignments, in order); operands: body
    Assert,       ///< arguments; operands: body, or kNone
    Echo,         ///< arguments; operands: body, or kNone
    Function,     ///< arguments: the parameters; operands: body
    // Elements of a Vector (and bodies of each other):
    ListFor,   ///< arguments: variables with their values; operands: body
    ListForC,  ///< for (init; condition; update) body. arguments: init, update (update_of); operands: body, condition
    ListIf,    ///< operands: condition, then, else (or kNone)
    ListLet,   ///< arguments; operands: body (always an element kind)
    ListEach,  ///< operands: body
};

/// Whether such an expression gives any number of elements of a list.
[[nodiscard]] constexpr bool is_element_kind(ExprKind kind) {
    return kind >= ExprKind::ListFor;
}

/// Whether such an expression is a value written out.
[[nodiscard]] constexpr bool is_literal_kind(ExprKind kind) {
    return kind <= ExprKind::String;
}

enum class Operator : std::uint8_t {
    None,
    Not,
    Negate,
    Plus,
    BitNot,  // unary
    Or,
    And,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    BitOr,
    BitAnd,
    ShiftLeft,
    ShiftRight,
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    Power
};

/// An argument `name = value` or `value`, a parameter `name` or `name = value`, or an assignment.
struct Argument {
    Symbol name = kNoSymbol;  ///< kNoSymbol: a positional argument.
    ExprId value = kNone;     ///< kNone: a parameter without default.
    SourceRange where;
};

struct Expr {
    ExprKind kind = ExprKind::Undef;
    Operator op = Operator::None;
    std::uint8_t links = 0;  ///< Of a chain (Binary, Index, Member) with what is left of it; 255 for more.
    Symbol name = kNoSymbol;
    std::array<ExprId, 3> operands{kNone, kNone, kNone};
    union {  // Hundreds of thousands of these are what a large library takes: no expression needs both.
        double number = 0;
        Run list;  ///< Of Program::arguments; for Vector, of Program::elements.
    };
    SourceRange where;

    Expr() {}
    [[nodiscard]] ExprId operand(std::size_t i) const { return operands[i]; }
};

struct FunctionDefinition {
    Symbol name = kNoSymbol;
    Run parameters{};            ///< Of Program::arguments.
    ExprId body = kNone;         ///< kNone while the body is lazy.
    std::uint32_t lazy = kNone;  ///< Index into Program::lazy.bodies, for build_function_body() (parser.h).
    SourceRange where;           ///< From `function` to the semicolon.
};

struct ModuleDefinition {
    Symbol name = kNoSymbol;
    Run parameters{};            ///< Of Program::arguments.
    BlockId body = kNone;        ///< kNone while the body is lazy.
    std::uint32_t lazy = kNone;  ///< Index into Program::lazy.bodies, for build_module_body() (parser.h).
    SourceRange where;
};

/// Modifiers before an instantiation, as a set of bits.
struct Modifiers {
    bool root : 1 = false;        ///< `!`
    bool highlight : 1 = false;   ///< `#`
    bool background : 1 = false;  ///< `%`
    bool disabled : 1 = false;    ///< `*`: to be evaluated as if it were not there.
};

/// `name(arguments) children`. `if` is one as well: name "if", one positional argument, the condition. Note that
/// `for`, `let`, `assert`, `echo` and `each` are ordinary names here.
struct Instantiation {
    Symbol name = kNoSymbol;
    bool is_if = false;
    Modifiers modifiers;
    Run arguments{};            ///< Of Program::arguments.
    BlockId children = kNone;   ///< Never kNone after parsing; empty for `name();`.
    BlockId otherwise = kNone;  ///< Of an `if` with `else`; `else if` is a block with one instantiation.
    SourceRange where;          ///< From the name to the closing parenthesis.
};

/// A scope. In each list things stand in source order. A variable assigned twice is listed once: at the place of the
/// first assignment, with the value and location of the last. Of functions (modules) of one name the last counts.
/// Braces that only group (`{ a = 1; cube(); }` as a statement) open no scope and leave no trace.
struct Block {
    Run assignments{};     ///< Of Program::assignments.
    Run functions{};       ///< Of Program::functions.
    Run modules{};         ///< Of Program::modules.
    Run instantiations{};  ///< Of Program::instantiations.
};

/// `use <path>`: functions and modules of another file.
struct Use {
    std::string path;     ///< As found; as written where it was not found.
    UnitId unit = kNone;  ///< kNone for a font, or where the file is missing or broken (which was reported).
    bool font = false;    ///< A .ttf or .otf file.
    SourceRange where;
};

/// A file with what it includes: the main file, or a used one. Units may use each other in circles.
struct Unit {
    std::uint32_t file = 0;  ///< Index into Program::sources.
    BlockId block = kNone;   ///< kNone where the file did not parse.
    std::vector<Use> uses;   ///< In source order; included files' uses count here. A path used twice is listed once.
};

struct Program {
    SourceSet sources;
    SymbolTable symbols;
    FlatArray<Expr> expressions;
    FlatArray<ExprId> elements;
    FlatArray<Argument> arguments;
    FlatArray<Argument> assignments;
    std::unordered_map<ExprId, Run> updates;                      ///< Of ListForC: a run of arguments.
    std::unordered_map<std::uint32_t, SourceRange> first_places;  ///< By index of assignments written more than once.
    FlatArray<FunctionDefinition> functions;
    FlatArray<ModuleDefinition> modules;
    FlatArray<Instantiation> instantiations;
    FlatArray<Block> blocks;
    std::vector<Unit> units;  ///< The main file is units[0].
    LazyBodies lazy;          ///< Of definitions at the top level of files; empty where all has been built.

    /// Whether the `otherwise` of an `if` is but another `if`.
    [[nodiscard]] bool is_else_if(const Block& b) const {
        if (b.instantiations.count != 1) {
            return false;
        }
        const Instantiation& only = instantiations[b.instantiations.first];
        return only.is_if && !only.modifiers.disabled && b.assignments.count == 0 && b.functions.count == 0 &&
               b.modules.count == 0;
    }
    [[nodiscard]] const Expr& operator[](ExprId id) const { return expressions[id]; }
    [[nodiscard]] std::span<const ExprId> elements_of(const Expr& vector) const { return run(elements, vector.list); }
    [[nodiscard]] std::span<const Argument> arguments_of(const Expr& e) const { return run(arguments, e.list); }
    [[nodiscard]] std::span<const Argument> update_of(const Expr& list_for) const {
        const auto found = updates.find(static_cast<ExprId>(&list_for - expressions.data()));
        return found == updates.end() ? std::span<const Argument>() : run(arguments, found->second);
    }
    [[nodiscard]] std::span<const Argument> arguments_of(const Instantiation& i) const {
        return run(arguments, i.arguments);
    }
    [[nodiscard]] std::span<const Argument> parameters_of(const FunctionDefinition& f) const {
        return run(arguments, f.parameters);
    }
    [[nodiscard]] std::span<const Argument> parameters_of(const ModuleDefinition& m) const {
        return run(arguments, m.parameters);
    }
    [[nodiscard]] std::span<const Argument> assignments_of(const Block& b) const {
        return run(assignments, b.assignments);
    }
    [[nodiscard]] std::span<const FunctionDefinition> functions_of(const Block& b) const {
        return run(functions, b.functions);
    }
    [[nodiscard]] std::span<const ModuleDefinition> modules_of(const Block& b) const { return run(modules, b.modules); }
    [[nodiscard]] std::span<const Instantiation> instantiations_of(const Block& b) const {
        return run(instantiations, b.instantiations);
    }

    /// Paths of the fonts of all `use <font.ttf>`, each once.
    [[nodiscard]] std::vector<std::string> fonts() const;

  private:
    template <typename T>
    static std::span<const T> run(const FlatArray<T>& all, Run r) {
        return {all.data() + r.first, r.count};
    }
};

/// As in source text: "+", "<=", "!".
[[nodiscard]] std::string_view operator_text(Operator op);

}  // namespace csg::scad
