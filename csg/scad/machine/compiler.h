// Compiles expressions (instruction.h). Internal to the evaluator.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "csg/scad/machine/instruction.h"
#include "csg/scad/machine/resolve.h"

namespace csg::scad {

/// What a compiler needs to know of the program, and of whom it works for. All must outlive it.
struct CompilerHost {
    const Program& program;
    const Resolution& resolution;
    BuiltinFunction is_undef;  ///< The one that may ask for a variable in silence.
    BuiltinFunction len;
    std::function<Value(Symbol text)> text;  ///< The value of a literal, which is shared.
    bool late_captures = false;              ///< Whether closures may have to wait for variables of a let.
    std::function<void(const SourceRange& where)> check_stack;  ///< Throws where the stack is nearly used up.
};

/// Makes the code of one expression or function.
class Compiler {
  public:
    /// `locals`: registers that the resolver has given away.
    Compiler(const CompilerHost& host, std::uint32_t locals);

    [[nodiscard]] Code statement(ExprId e);
    [[nodiscard]] Code function(std::span<const Argument> parameters, ExprId body, std::uint32_t this_parameter);

  private:
    static constexpr std::uint8_t kLongChain = 64;  ///< Links; longer ones are compiled in a loop.
    using Jumps = std::vector<std::uint32_t>;       ///< Instructions whose target is still to be known.

    /// Gives back the temporaries that were taken since.
    class Temporaries {
      public:
        explicit Temporaries(Compiler& c) : c_(c), next_(c.next_) {}
        ~Temporaries() { c_.next_ = next_; }
        Temporaries(const Temporaries&) = delete;
        Temporaries& operator=(const Temporaries&) = delete;

      private:
        Compiler& c_;
        Register next_;
    };

    // compiler.cpp

    Register take(std::uint32_t count = 1);
    Operand constant(Value value);
    std::uint32_t emit(const Instruction& i);
    std::uint32_t here() const { return static_cast<std::uint32_t>(code_.instructions.size()); }
    void land(const Jumps& jumps);
    [[nodiscard]] Code finish();
    [[nodiscard]] bool is_temporary(Register r) const { return r >= locals_; }
    [[nodiscard]] bool is_constant_list(ExprId id) const;
    [[nodiscard]] Value literal(const Expr& e) const;
    [[nodiscard]] Value constant_list(ExprId id) const;
    [[nodiscard]] bool dynamic_name(Symbol name) const;
    [[nodiscard]] std::uint32_t slot_of(const Argument& a) const;
    [[nodiscard]] std::size_t argument_index(const Argument& a) const;

    // compile_expression.cpp

    void move(Operand from, Register target);
    [[nodiscard]] bool lies_ready(ExprId id) const;
    bool index_of_block(ExprId id, Register target);
    /// The value of an expression where it lies, else in `hint`, or a new temporary.
    Operand operand(ExprId id, Register hint = kNone);
    /// Nothing but the last instruction writes to `target` if it is no temporary.
    void into(ExprId id, Register target);
    void into_one(ExprId id, Register target);
    void tail(ExprId id);
    void variable(ExprId id, Register target);
    void unary(ExprId id, Register target);
    void chain(ExprId id, Register target);
    /// A link of a chain whose left operand is known.
    void link(ExprId id, Operand left, Register target);
    void range(ExprId id, Register first);

    // compile_binding.cpp

    void let(const Expr& e, Register target);
    void bind(std::span<const Argument> arguments);
    void assertion(ExprId id);
    void echo(ExprId id);
    [[nodiscard]] bool binds_dynamic(std::span<const Argument> arguments) const;

    // compile_condition.cpp

    /// Jumps where the truth of an expression is `when`.
    void branch(ExprId id, bool when, Jumps& jumps);
    bool branch_binary(ExprId id, bool when, Jumps& jumps);
    /// `and` and `or`: true or false.
    void truth(ExprId id, Register target);
    void truth_of_link(const Expr& e, Operand left, Register target);
    void choose(const Jumps& otherwise, bool value, Register target);

    // compile_list.cpp

    void vector(ExprId id, Register target);
    void gather(ExprId id, Register target);
    void element(ExprId id);
    void element_but_if(ExprId id);
    void loop(ExprId id, std::span<const Argument> left);
    void loop_for_c(ExprId id);

    // compile_call.cpp

    /// `tail`: in place of the function that it ends.
    void call(ExprId id, Register target, bool tail);
    void call_builtin(ExprId id, std::uint32_t call, Register target, bool tail);
    void call_function(ExprId id, std::uint32_t call, Register target, bool tail);
    void call_any(ExprId id, std::uint32_t call, bool find, Register target, bool tail);
    void finish_call(Operand result, Register target, bool tail);
    void silent_argument(ExprId id, Register target);
    /// By argument the parameter that it is for; empty where it takes more to find out.
    [[nodiscard]] std::vector<std::uint32_t> places_of(std::span<const Argument> arguments,
                                                       std::span<const Argument> parameters) const;
    void note_arguments(std::uint32_t begin, ExprId call);
    [[nodiscard]] Register call_window(Register target) const;

    const CompilerHost& host_;
    const Program& p_;
    const Resolution& r_;
    Code code_;
    const std::uint32_t locals_;
    Register next_;
    std::vector<Register> carried_;  ///< Variables of loops that may be unset.
};

}  // namespace csg::scad
