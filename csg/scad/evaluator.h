// Runs a program. Internal to csg/scad: use scad.h.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "csg/scad/ast.h"
#include "csg/scad/builtin_functions.h"
#include "csg/scad/resolver.h"
#include "csg/scad/scad.h"
#include "csg/scad/trace.h"
#include "csg/scad/value.h"
#include "csg/tree/tree.h"

namespace csg::scad {

/// Ends an evaluation: a failed assertion, recursion without end, a limit, a stop.
struct EvaluationError {
    Message message;
    bool stopped = false;
    std::vector<Message> trace;  ///< What was under way, the innermost first.
};

/// A user-defined module that runs.
struct ModuleCall;

/// The variables of a block that runs. Frames live on the native stack, and nothing that a module makes outlives it:
/// what refers to a frame needs no ownership.
struct Frame {
    const Frame* outer = nullptr;
    Value* slots = nullptr;
    const ModuleCall* module = nullptr;  ///< The one whose body the block is in, for children().
};

struct ModuleCall {
    const Instantiation* instantiation = nullptr;
    const Frame* caller = nullptr;  ///< Where its children are to run.
};

/// A function literal with what it uses of its surroundings.
struct Closure final : FunctionObject {
    Closure(const Program& p, ExprId e, const Frame* f, bool takes)
        : FunctionObject(takes), program(p), literal(e), frame(f) {}
    [[nodiscard]] std::string text() const override;
    void take_captures(std::vector<Value>& out) override;
    const Program& program;
    const ExprId literal;
    const Frame* const frame;
    std::vector<Value> captures;  ///< Unset stands for the closure itself.
};

/// Where an expression runs.
struct Scope {
    Value* locals = nullptr;
    const Frame* frame = nullptr;
    Closure* closure = nullptr;
};

/// Locals of activations and slots of frames, in chunks that never move.
class ValueStack {
  public:
    /// `count` values, all unset, until it is destroyed. Regions nest.
    class Region {
      public:
        Region(ValueStack& stack, std::size_t count);
        ~Region();
        Region(const Region&) = delete;
        Region& operator=(const Region&) = delete;
        [[nodiscard]] Value* data() const { return data_; }
        /// Takes over the values of `newer`, the innermost region; grows where they do not fit.
        void replace(Region& newer);
        void release();

      private:
        ValueStack& stack_;
        std::size_t chunk_, top_, count_;
        Value* data_;
    };

  private:
    Value* take(std::size_t count);
    struct Chunk {
        std::unique_ptr<Value[]> values;
        std::size_t size;
    };
    std::vector<Chunk> chunks_;
    std::size_t chunk_ = 0;
    std::size_t top_ = 0;
};

using Nodes = std::vector<NodeId>;

class Evaluator {
  public:
    /// Builds bodies of the program that are lazy; nothing else of it changes.
    Evaluator(Program& program, const Request& request, MessageSink sink, const char* stack_limit);
    ~Evaluator();
    Evaluator(const Evaluator&) = delete;
    Evaluator& operator=(const Evaluator&) = delete;

    /// Runs the main file. Throws EvaluationError.
    Tree run(ViewSettings& view);

    // For built-in modules (builtin_modules.h).

    [[nodiscard]] const Program& program() const { return p_; }
    [[nodiscard]] const Request& request() const { return request_; }
    [[nodiscard]] TreeBuilder& builder() { return builder_; }
    [[nodiscard]] const std::string& name(Symbol symbol) const { return p_.symbols.text(symbol); }
    void warn(const SourceRange& where, std::string text);
    void emit(Severity severity, const SourceRange& where, std::string text);
    [[noreturn]] void fail(const SourceRange& where, std::string text);
    [[nodiscard]] SourceLocation location(const SourceRange& where);
    /// What `$fn`, `$fa` and `$fs` say now; warns at `where` of values that are too small.
    [[nodiscard]] Fineness fineness(const SourceRange& where);
    /// Restores `$` variables to what they were.
    class DynamicMark {
      public:
        explicit DynamicMark(Evaluator& e) : e_(e), mark_(e.undo_.size()) {}
        ~DynamicMark() { e_.unwind(mark_); }
        DynamicMark(const DynamicMark&) = delete;
        DynamicMark& operator=(const DynamicMark&) = delete;

      private:
        Evaluator& e_;
        std::size_t mark_;
    };
    void bind_dynamic(std::uint32_t index, Value value);
    [[nodiscard]] bool dynamic_name(Symbol name) const { return r_.dynamic_of_symbol[name] != kNone; }
    /// Binds an argument whose name begins with `$`.
    void bind_dynamic(const Argument& a, Value value) {
        bind_dynamic(r_.argument_slots[index_of(a)], std::move(value));
    }
    [[nodiscard]] Value statement_value(ExprId e, const Frame* frame);
    /// The children of an instantiation, in a frame of their own.
    void children_of(const Instantiation& i, const Frame* frame, Nodes& out);
    void run_block(BlockId block, const Frame* frame, Nodes& out);
    /// Only some of the children of a module call; an index is of its instantiations.
    void run_child(const ModuleCall& call, std::size_t index, Nodes& out);
    [[nodiscard]] std::size_t child_count(const ModuleCall& call) const;
    void assign(const Argument& a, Value value, const Frame& frame);
    /// Whether one of the arguments before `a` has its name.
    [[nodiscard]] static bool is_repeated(std::span<const Argument> arguments, const Argument& a);
    /// A frame for `block` inside `outer`, as long as it lives; `$` variables are as before afterwards.
    class BlockFrame {
      public:
        BlockFrame(Evaluator& e, BlockId block, const Frame* outer)
            : mark_(e),
              slots_(e.stack_, e.r_.frame_slots[block] == kNone ? 0 : e.r_.frame_slots[block]),
              own_{outer, slots_.data(), outer->module},
              used_(e.r_.frame_slots[block] == kNone ? outer : &own_) {}
        BlockFrame(const BlockFrame&) = delete;
        BlockFrame& operator=(const BlockFrame&) = delete;
        [[nodiscard]] const Frame* get() const { return used_; }

      private:
        DynamicMark mark_;
        ValueStack::Region slots_;
        Frame own_;
        const Frame* used_;
    };
    [[nodiscard]] csg::Modifiers modifiers(const Instantiation& i) const;
    void echo_statement(const Instantiation& i, const Frame* frame);
    void assert_statement(const Instantiation& i, const Frame* frame);
    void check_stop(const SourceRange& where) {
        if ((++steps_ & 1023U) == 0 && request_.stop.stop_requested()) {
            fail_stopped(where);
        }
    }
    [[nodiscard]] const Resolution& resolution() const { return r_; }
    /// That the program needs a file besides its sources.
    void note_data_file(const std::string& path) { data_files_.insert(path); }
    [[nodiscard]] const std::set<std::string>& data_files() const { return data_files_; }

  private:
    friend class DynamicMark;

    /// Notes that something is under way, as long as it lives.
    class Step {
      public:
        Step(Evaluator& e, ActiveStep step) : e_(e), step_(step) {
            step_.outer = e.innermost_;
            e.innermost_ = &step_;
        }
        ~Step() { e_.innermost_ = step_.outer; }
        Step(const Step&) = delete;
        Step& operator=(const Step&) = delete;
        /// A tail call takes the place of the call it ends.
        void change(const SourceRange& where, Symbol name) {
            step_.where = &where;
            step_.name = name;
        }

      private:
        Evaluator& e_;
        ActiveStep step_;
    };
    [[nodiscard]] std::size_t index_of(const Argument& a) const {
        return static_cast<std::size_t>(&a - p_.arguments.data());
    }
    [[noreturn]] void fail_stopped(const SourceRange& where);
    [[noreturn]] void fail_limit(const SourceRange& where, const ValueLimit& limit);
    [[noreturn]] void fail_recursion(const SourceRange& where, std::string_view what, Symbol name);
    /// Value of a `$` variable that the program may not mention.
    [[nodiscard]] const Value* special(std::uint32_t index) const {
        return index == kNone ? nullptr : &dynamic_[index];
    }
    void set_special(std::string_view name, Value value);
    void take_view(ViewSettings& view);
    NodeId find_root(NodeId top);

    // evaluate_expression.cpp
    Value evaluate(ExprId id, Scope& scope);
    Value evaluate_chain(const Expr& e, Scope& scope);
    Value apply(const Expr& e, const Value& a, Scope& scope);
    Value apply_any(const Expr& e, const Value& a, const Value& b);
    Value evaluate_vector(ExprId id, Scope& scope);
    Value evaluate_unary(const Expr& e, Scope& scope);
    const Value& operand(ExprId id, Scope& scope, Value& temporary);
    const Value& text_constant(Symbol text);
    bool is_true(ExprId id, Scope& scope);
    Value evaluate_range(const Expr& e, Scope& scope);
    Value make_closure(ExprId id, Scope& scope);
    void bind_let(std::span<const Argument> arguments, Scope& scope);
    void settle(std::size_t first, const Value* slot);
    void bind_local(const Argument& a, Value value, Scope& scope);
    Value variable(const VariableRef& ref, const Scope& scope) const;
    Value variable_or_warn(ExprId id, const Scope& scope);
    const Frame* outward(const Frame* frame, std::uint32_t hops) const;

    void echo(std::span<const Argument> arguments, Scope& scope);
    void check_assertion(std::span<const Argument> arguments, const SourceRange& where, Scope& scope);

    // evaluate_list.cpp
    void collect(ExprId element, Scope& scope, std::vector<Value>& out);
    void collect_for(const Expr& e, std::span<const Argument> left, Scope& scope, std::vector<Value>& out);
    void collect_for_c(ExprId id, Scope& scope, std::vector<Value>& out);
    void collect_each(const Value& value, const SourceRange& where, std::vector<Value>& out);

    // evaluate_call.cpp
    struct Callee;
    void enter(Callee& callee, Value* slots);
    Value call(ExprId id, Scope& scope);
    bool find_callee(const Expr& e, ExprId id, Scope& scope, Callee& callee);
    Value call_builtin(const Expr& e, BuiltinFunction function, Scope& scope);
    void bind_arguments(std::span<const Argument> arguments, std::span<const Argument> parameters,
                        const SourceRange& where, Scope& caller, Value* slots,
                        std::vector<std::pair<Symbol, Value>>* others = nullptr);
    void bind_defaults(std::span<const Argument> parameters, Scope& defining, Value* slots);

    // evaluate_module.cpp
    void instantiate(const Instantiation& i, const Frame* frame, Nodes& out);
    void instantiate_if(const Instantiation& i, const Frame* frame, Nodes& out);
    void instantiate_user(const Instantiation& i, const DefinitionRef& definition, const Frame* frame, Nodes& out);
    void run_assignments(const Block& block, const Frame& frame);
    const Frame* unit_frame(UnitId unit);
    const Frame* enter_unit(UnitId unit);

    void unwind(std::size_t mark);
    /// Fails where the stack is nearly used up. `reserve` is what must be left: calls ask for more than expressions, so
    /// that endless recursion is found, and named, at a call.
    void check_stack(const SourceRange& where, std::string_view what, Symbol name, std::size_t reserve) {
        const char here = 0;
        if (&here < stack_limit_ + reserve) {
            fail_recursion(where, what, name);
        }
    }
    static constexpr std::size_t kCallReserve = std::size_t{2} << 20;

    const Program& p_;
    const Request& request_;
    MessageSink sink_;
    const char* stack_limit_;
    Resolver resolver_;
    const Resolution& r_;
    FunctionHost host_;
    const ActiveStep* innermost_ = nullptr;
    SourceRange call_where_;
    std::span<const Argument> call_arguments_;  ///< Of the built-in function that runs.
    ValueStack stack_;
    std::vector<Value> dynamic_;
    std::vector<Value> strings_;    ///< By symbol, once they are used. Never moves.
    std::vector<Value> constants_;  ///< Of constant lists, once they are used.
    struct Undo {
        std::uint32_t index;
        Value before;
    };
    std::vector<Undo> undo_;
    struct Late {
        Value closure;
        std::size_t capture;
        const Value* slot;
    };
    std::vector<Late> late_;                                         ///< Captures that wait for their variable.
    std::vector<std::pair<std::uint32_t, Value>> pending_dynamics_;  ///< `$` arguments of the call being bound.
    std::vector<Value> knotted_;  ///< Closures that may hold each other: untied at the end.
    struct UnitFrame {
        Frame frame;
        std::vector<Value> slots;
        std::vector<std::pair<std::uint32_t, Value>> dynamics;  ///< The `$` variables that the file sets.
        bool ready = false;
    };
    std::vector<UnitFrame> units_;
    TreeBuilder builder_;
    std::vector<std::uint32_t> tree_files_;  ///< By file of the SourceSet.
    std::vector<std::uint32_t> source_of_;   ///< The other way round.
    bool has_root_modifier_ = false;
    BuiltinFunction is_undef_;            ///< The one that may ask for a variable in silence.
    std::uint32_t parent_modules_index_;  ///< Dynamic indices; kNone where the program does not mention the variable.
    std::uint32_t fn_index_, fa_index_, fs_index_;
    std::uint32_t steps_ = 0;
    std::size_t nodes_ = 0;
    std::set<std::string> data_files_;
};

}  // namespace csg::scad
