// Runs a program. Internal to csg/scad: use scad.h.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "csg/scad/builtin/builtin_functions.h"
#include "csg/scad/machine/compiled.h"
#include "csg/scad/machine/compiler.h"
#include "csg/scad/machine/trace.h"
#include "csg/scad/scad.h"
#include "csg/scad/syntax/ast.h"
#include "csg/scad/value/value.h"
#include "csg/scad/value/value_stack.h"
#include "csg/tree/tree.h"

namespace csg::scad {

/// Ends an evaluation: a failed assertion, recursion without end, a limit, a stop.
struct EvaluationError {
    Message message;
    bool stopped = false;
    std::vector<Message> trace;  ///< What was under way, the innermost first.
    bool out_of_memory = false;
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
    const Code* code = nullptr;   ///< Once it was called.
    std::vector<Value> captures;  ///< Unset stands for the closure itself.
};

using Nodes = std::vector<NodeId>;

class Evaluator {
  public:
    /// `compiled` is of the program, and grows with what is run. All must outlive it.
    Evaluator(const Program& program, Compiled& compiled, const Request& request, MessageSink sink,
              const char* stack_limit);
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
    [[nodiscard]] SourceLocation location(const SourceRange& where) const;
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
    /// The value of an expression of a statement.
    [[nodiscard]] Value statement_value(ExprId e, const Frame* frame);
    /// The children of an instantiation, in a frame of their own.
    void children_of(const Instantiation& i, const Frame* frame, Nodes& out);
    void run_block(BlockId block, const Frame* frame, Nodes& out);
    /// Only some of the children of a module call; an index is of its instantiations.
    void run_child(const ModuleCall& call, std::size_t index, Nodes& out);
    [[nodiscard]] std::size_t child_count(const ModuleCall& call) const;
    void assign(const Argument& a, Value value, const Frame& frame);
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
        if (request_.stop.stop_requested()) {
            fail_stopped(where);
        }
    }
    [[nodiscard]] const Resolution& resolution() const { return r_; }
    /// That the program needs a file besides its sources.
    void note_data_file(const std::string& path) { data_files_.try_emplace(path, disk_state(path)); }
    /// As they were before they were read.
    [[nodiscard]] const std::map<std::string, DiskState>& data_files() const { return data_files_; }

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

      private:
        Evaluator& e_;
        ActiveStep step_;
    };
    [[nodiscard]] std::size_t index_of(const Argument& a) const {
        return static_cast<std::size_t>(&a - p_.arguments.data());
    }
    [[noreturn]] void fail_stopped(const SourceRange& where);
    [[noreturn]] void fail_limit(const SourceRange& where, const ValueLimit& limit);
    [[noreturn]] void fail_out_of_memory(const SourceRange& where);
    [[noreturn]] void fail_recursion(const SourceRange& where, std::string_view what, Symbol name);
    /// Value of a `$` variable that the program may not mention.
    [[nodiscard]] const Value* special(std::uint32_t index) const {
        return index == kNone ? nullptr : &dynamic_[index];
    }
    void set_special(std::string_view name, Value value);
    void exchange_code();
    void take_view(ViewSettings& view);
    /// The statement has made so many nodes; fails where there are too many now.
    void count_nodes(const Instantiation& i, std::size_t made);
    /// Notes that the statement made a node.
    void note_statement(const Instantiation& i);
    [[nodiscard]] std::vector<Statement> noted_statements() const;
    NodeId find_root(NodeId top);

    class Activation;
    struct Callee;
    using Dynamics = std::vector<std::pair<std::uint32_t, Value>>;  ///< `$` variables by index.

    // machine.cpp

    /// Runs what `a` stands for, from the instruction `entry` on.
    Value run(Activation& a, std::uint32_t entry);

    // machine_values.cpp

    Value variable(const VariableRef& ref, const Frame* frame, const Activation* a);
    Value variable_or_warn(const Instruction& i, const Activation& a);
    Value unknown_variable(ExprId id);
    const Value& text_constant(Symbol text);
    Value apply_binary(const Instruction& i, const Value& a, const Value& b);
    bool compare(const Instruction& i, const Value& a, const Value& b);
    Value apply_unary(const Instruction& i, const Value& a);
    static Value member_of(const Value& value, std::string_view member);
    bool check_range(ExprId id, const Value* parts);
    Value make_closure(ExprId id, Activation& a);
    void settle(const Value* slot);
    void warn_assignment(const Instruction& i, const Value& value);
    void echo(std::span<const Argument> arguments, const Value* values);
    [[noreturn]] void fail_assertion(const SourceRange& where, ExprId condition, const Value* message);

    // machine_list.cpp

    void append_each(const Value& value, const SourceRange& where);
    Value take_gathered(std::size_t begin);
    bool begin_loop(const Instruction& i, const Value& values, Value* loop, Value& variable);
    bool begin_range_loop(const Instruction& i, Value* loop, Value& variable);
    static Value loop_value(Value* loop);
    void check_loop(const SourceRange& where);
    void count_round(const Instruction& i, Value& round);

    // machine_call.cpp

    [[nodiscard]] static const Frame* outward(const Frame* frame, std::uint32_t hops) {
        for (; hops > 0; --hops) {
            frame = frame->outer;
        }
        return frame;
    }
    [[nodiscard]] CompilerHost compiler_host();
    const Code& compile_function(std::uint32_t id);
    const Code& function_code(std::uint32_t id) {
        return function_codes_[id] != nullptr ? *function_codes_[id] : compile_function(id);
    }
    const Code& literal_code(ExprId literal);
    const Code& statement_code(ExprId id);
    Value call_function(const Instruction& i, Activation& caller);
    const Frame* frame_of(const DefinitionRef& definition, const Frame* caller);
    bool find_callee(const Instruction& i, Activation& a);
    void warn_no_function(ExprId call);
    void warn_no_callee(const Instruction& i, const Value& value);
    Callee prepare(const Instruction& i, Activation& caller);
    void bind(Callee& callee, std::span<const Argument> arguments, const SourceRange& where);
    void enter(Activation& a, Callee& callee);
    Value call_any(const Instruction& i, Activation& caller);
    bool replace(const Instruction& i, Activation& a, unsigned tail_calls, std::uint32_t& entry, Value& result);
    Value call_builtin(ExprId call, std::uint32_t target, std::span<const Value> arguments);
    /// The `values` of the arguments, which are moved, go to the slots of the parameters they are for; parameters
    /// without one stay as they are. Named arguments that are for no parameter go to `others`.
    void bind_arguments(std::span<const Argument> arguments, Value* values, std::span<const Argument> parameters,
                        const SourceRange& where, Value* slots, Dynamics& dynamics,
                        std::vector<std::pair<Symbol, Value>>* others = nullptr);

    // evaluate_module.cpp
    void instantiate(const Instantiation& i, const Frame* frame, Nodes& out);
    void instantiate_if(const Instantiation& i, const Frame* frame, Nodes& out);
    void instantiate_user(const Instantiation& i, const DefinitionRef& definition, const Frame* frame, Nodes& out);
    void bind_module(const Instantiation& i, std::span<const Argument> parameters, const Frame* frame, Value* slots,
                     Dynamics& dynamics, std::vector<std::pair<Symbol, Value>>& others);
    void bind_defaults(std::span<const Argument> parameters, const Frame* defining, Value* slots);
    void run_assignments(const Block& block, const Frame& frame);

    // evaluate_unit.cpp

    struct UnitFrame;
    /// The frame that functions and modules of a used file run in when they are called now.
    const Frame* enter_unit(UnitId unit);
    UnitFrame& evaluate_unit(UnitId unit);
    /// To be told of each reading of a `$` variable by an expression.
    void note_read(std::uint32_t index) {
        if (!readings_.empty()) {
            note_read_of(index);
        }
    }
    void note_read_of(std::uint32_t index);

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
    const Resolution& r_;
    FunctionHost host_;
    const ActiveStep* innermost_ = nullptr;
    ExprId call_ = kNone;  ///< Of the built-in function that runs.
    ValueStack stack_;
    std::vector<Value> dynamic_;
    std::vector<Value> strings_;   ///< By symbol, once they are used. Does not move.
    std::vector<Value> gathered_;  ///< Elements of the lists that are being made, the innermost last.
    std::deque<Code> codes_;
    std::vector<const Code*> function_codes_, literal_codes_;  ///< Null until they are called.
    CodeTable statement_codes_;
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
    std::vector<Late> late_;      ///< Captures that wait for their variable.
    std::vector<Value> knotted_;  ///< Closures that may hold each other: untied at the end.
    /// What the assignments of a file gave once.
    struct UnitFrame {
        Frame frame;
        std::vector<Value> slots;
        Dynamics reads;  ///< The `$` variables of others that it depends on, as they were.
    };
    struct Unit {
        std::deque<UnitFrame> frames;  ///< All: closures may refer to them.
        std::vector<UnitFrame*> kept;  ///< Those that may serve again, the last used first.
        UnitFrame* running = nullptr;
    };
    std::vector<Unit> units_;
    struct Reading {
        Dynamics* reads;
        std::size_t mark;  ///< Where its own bindings begin in `undo_`.
    };
    std::vector<Reading> readings_;  ///< By evaluations of files that are under way.
    TreeBuilder builder_;
    std::vector<std::uint32_t> tree_files_;  ///< By file of the SourceSet.
    std::vector<std::uint32_t> source_of_;   ///< The other way round.
    bool has_root_modifier_ = false;
    BuiltinFunction is_undef_, len_;
    std::uint32_t parent_modules_index_;  ///< Dynamic indices; kNone where the program does not mention the variable.
    std::uint32_t fn_index_, fa_index_, fs_index_, fe_index_;
    std::size_t nodes_ = 0;
    std::vector<char> noted_;  ///< By instantiation; the last may be missing.
    std::map<std::string, DiskState> data_files_;
    Resolver& resolver_;
    Compiled& compiled_;  ///< Its code is here while it grows: `run` asks for it at every call.
};

}  // namespace csg::scad
