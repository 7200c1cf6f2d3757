// What runs on the machine. Internal to machine*.cpp.
#pragma once

#include "csg/scad/machine/evaluator.h"
#include "csg/scad/machine/instruction.h"

namespace csg::scad {

// The registers of a loop. Of a range or a number they hold its numbers, else what is gone through; of a string the
// last is the byte where the next character begins.
inline constexpr std::size_t kLoopValues = 0, kLoopIndex = 1, kLoopCount = 2, kLoopStep = 3;

/// A function, or the expression of a statement, that runs. Activations nest.
class Evaluator::Activation {
  public:
    /// `values`: where the first `used` registers lie, in the innermost region of the stack. `where` and `called`: the
    /// call, as traces show it.
    Activation(Evaluator& e, const Code& c, Value* values, std::size_t used, const Frame* f, const SourceRange* where,
               Symbol called)
        : code(&c), frame(f), e_(e), mark_(e.stack_.mark()), dynamics_(e.undo_.size()) {
        registers = e.stack_.extend(values, c.registers, used);
        step.where = where;
        step.name = called;
        step.code = code;
        step.outer = e.innermost_;
        e.innermost_ = &step;
    }
    ~Activation() {
        if (e_.undo_.size() != dynamics_) {
            e_.unwind(dynamics_);
        }
        drop(0);
        e_.stack_.restore(mark_);
        e_.innermost_ = step.outer;
    }
    Activation(const Activation&) = delete;
    Activation& operator=(const Activation&) = delete;

    /// Another function takes the place of this one: its first `count` registers are moved from `values`, which are
    /// some of this one's.
    void replace(const Code& c, Value* values, std::size_t count) {
        std::move(values, values + count, registers);
        drop(count);
        code = &c;
        step.code = &c;
        registers = e_.stack_.extend(registers, c.registers, count);
    }
    /// The same with values that lie elsewhere.
    void replace(const Code& c, std::vector<Value>& values) {
        drop(0);
        code = &c;
        step.code = &c;
        registers = e_.stack_.extend(registers, c.registers, 0);
        std::move(values.begin(), values.end(), registers);
    }

    const Code* code;
    Value* registers;
    const Frame* frame;
    Value function;  ///< The function value that runs, if it is one.
    ActiveStep step;

    [[nodiscard]] Closure& closure() const { return static_cast<Closure&>(function.function()); }

  private:
    void drop(std::size_t first) {
        for (Value *v = registers + first, *end = registers + code->registers; v < end; ++v) {
            v->drop();
        }
    }
    Evaluator& e_;
    const ValueStack::Mark mark_;
    const std::size_t dynamics_;
};

}  // namespace csg::scad
