// Works out a Resolution. Internal to resolve.
#pragma once

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "csg/scad/machine/resolve.h"

namespace csg::scad {

using Names = std::unordered_map<Symbol, std::uint32_t>;

/// A block while it is resolved, and what it declares.
struct BlockScope {
    const BlockScope* outer = nullptr;
    bool framed = false;
    UnitId unit = kNone;  ///< For the root block of a unit.
    Names variables;      ///< Slots of the frame.
    Names functions;      ///< Indices into Program::functions.
    Names modules;        ///< Indices into Program::modules.
};

/// The locals of a function, a literal, or the expression of a statement.
struct Activation {
    struct Local {
        Symbol name;
        std::uint32_t slot;
        bool pending;  // Its value is being worked out; only literals see it.
    };
    Activation* outer = nullptr;  ///< Around a literal.
    LiteralInfo* literal = nullptr;
    std::vector<Symbol> capture_names;
    std::vector<Local> locals;  ///< Visible ones, the innermost last.
    std::uint32_t used = 0;
    std::uint32_t most = 0;

    std::uint32_t reserve() {
        most = std::max(most, used + 1);
        return used++;
    }
};

/// Functions and modules at the top level of a file are resolved when somebody asks for them, and their bodies built
/// where they are lazy: of a library that is included, a program uses a few.
class Resolver {
  public:
    /// Resolves the statements of the main file. The program must outlive it.
    explicit Resolver(Program& program);
    Resolver(const Resolver&) = delete;
    Resolver& operator=(const Resolver&) = delete;

    /// Grows with what is asked for: references into its vectors hold until the next question.
    [[nodiscard]] const Resolution& resolution() const { return r_; }
    /// Each makes sure that the tables know about it, with all that is inside it.
    void need_function(std::uint32_t id) {
        if (!function_known_[id]) {
            resolve_top_function(id);
        }
    }
    void need_module(std::uint32_t id) {
        if (!module_known_[id]) {
            resolve_top_module(id);
        }
    }
    /// The assignments of a used file.
    void need_unit(UnitId unit);
    /// The main file's block has other assignments now, to variables of the same names. What was found out about all
    /// else stays.
    void redefine();

  private:
    void resolve_top_function(std::uint32_t id);
    void resolve_top_module(std::uint32_t id);
    /// Makes the tables as long as the program's arrays are now. They do not move.
    void grow();
    void reserve();
    void number_dynamic_names();

    // resolve.cpp

    std::uint32_t index_of(const Argument& a) const { return static_cast<std::uint32_t>(&a - p_.arguments.data()); }
    std::uint32_t dynamic(Symbol name) const { return r_.dynamic_of_symbol[name]; }
    bool dynamic_name(Symbol name) const { return r_.dynamic_of_symbol[name] != kNone; }
    void declare(BlockId id, BlockScope& scope, const BlockScope* outer, std::span<const Argument> extra, bool root);
    void resolve_main_assignments();
    void resolve_assignments(const Block& block, const BlockScope& scope);
    void resolve_instantiations(const Block& block, const BlockScope& scope);
    void resolve_block(BlockId id, const BlockScope& scope);
    void resolve_definition(const FunctionDefinition& f, const BlockScope& scope);
    void resolve_definition(const ModuleDefinition& m, const BlockScope& scope);
    /// Lists of constants are made once: marks the list where all its elements are known.
    void mark_constant(ExprId list);
    /// Names of the arguments that calls of modules pass anywhere in the program.
    void gather_passed();
    void mark_repeated(std::span<const Argument> parameters);
    /// What calls of a module need to know besides its parameters.
    void look_into(const ModuleDefinition& m, BlockScope& body);
    void resolve_instantiation(const Instantiation& first, const BlockScope& scope);
    void resolve_head_and_children(const Instantiation& i, const BlockScope& scope);
    DefinitionRef find_module(Symbol name) const { return find_definition(name, &BlockScope::modules); }
    DefinitionRef find_definition(Symbol name, Names BlockScope::*table) const;
    /// In one scope; in the root of a unit also in the files it uses.
    DefinitionRef definition_in(const BlockScope& s, Symbol name, Names BlockScope::*table, std::uint32_t hops) const;

    // resolve_expression.cpp

    void statement_expression(ExprId e);
    void resolve_function(std::span<const Argument> parameters, ExprId body, Activation& activation);
    void call_arguments(const Expr& e);
    /// Variables of a let or for, in order; each sees those before it. Returns how many locals were visible before.
    void bind(std::span<const Argument> arguments);
    void resolve_expression(ExprId id);
    /// Resolves all of an expression but one operand, which is returned: chains need no stack.
    ExprId resolve_one(ExprId id);
    /// A variable that only the updates of a loop assign to hides the one outside from the second round on: it is
    /// one of the loop's own that begins with the value outside.
    void carry_in(ExprId loop, std::size_t first);
    /// Updates assign to the loop's own variables.
    void bind_update(std::span<const Argument> update, std::size_t first);
    void resolve_literal(ExprId id, const Expr& e);
    std::uint32_t add(VariableRef ref);
    /// Among the locals of `act`, and those around it if it belongs to a literal.
    VariableRef find_local(Activation& act, Symbol name, bool from_literal);
    VariableRef find_variable(Symbol name);
    VariableRef find_in_blocks(Symbol name, const BlockScope* s, std::uint32_t hops);
    std::uint32_t find_call(Symbol name);

    Program& p_;  ///< Lazy bodies are built; nothing else changes.
    Resolution r_;
    std::vector<std::pair<Symbol, Symbol>> passed_;  ///< Module called and name of an argument, sorted.
    bool passed_known_ = false;
    std::vector<BlockScope> roots_;
    std::vector<bool> function_known_, module_known_, unit_known_;
    std::unordered_set<ExprId> main_values_;  ///< Of the main file's assignments, those that are resolved.
    std::vector<UnitId> unit_of_function_, unit_of_module_;  ///< Of those at top level.
    const BlockScope* block_ = nullptr;
    Activation* activation_ = nullptr;
};

}  // namespace csg::scad
