// Built-in modules that decide which children there are: for, let, children, echo, assert.
#include <algorithm>
#include <array>
#include <cmath>

#include "csg/scad/builtin/builtin_modules.h"
#include "csg/scad/machine/sequence.h"
#include "csg/scad/syntax/argument_roles.h"

namespace csg::scad {

namespace {

void combine(const ModuleContext& c, Operation operation, const Nodes& children, Nodes& out) {
    out.push_back(c.evaluator.builder().combine(operation, children, c.location(), c.modifiers));
}

/// A group; of the experiment lazy-union the children themselves, where nothing is to be said of all of them.
void group(const ModuleContext& c, const Nodes& children, Nodes& out) {
    if (c.evaluator.request().lazy_union && c.modifiers == csg::Modifiers{}) {
        out.insert(out.end(), children.begin(), children.end());
    } else {
        combine(c, Operation::Group, children, out);
    }
}

/// A loop of a for: runs the children once for each combination of the values of its variables.
class ForLoop {
  public:
    ForLoop(const ModuleContext& c, Nodes& out)
        : c_(c),
          evaluator_(c.evaluator),
          block_(c.instantiation.children),
          arguments_(evaluator_.program().arguments_of(c.instantiation)),
          frame_(evaluator_, block_, c.frame),
          out_(out) {
        const Resolution& r = evaluator_.resolution();
        for (const Argument& a : evaluator_.program().assignments_of(evaluator_.program().blocks[block_])) {
            const std::uint32_t slot =
                r.assignment_slots[static_cast<std::size_t>(&a - evaluator_.program().assignments.data())];
            const bool loop_variable = std::any_of(arguments_.begin(), arguments_.end(),
                                                   [&](const Argument& argument) { return argument.name == a.name; });
            if (!evaluator_.dynamic_name(a.name)) {
                (loop_variable ? shared_slots_ : inner_slots_).push_back(slot);
            }
        }
    }

    void run() {
        if (!arguments_.empty()) {
            run(0);
        }
    }

  private:
    void run(std::size_t variable) {
        if (variable == arguments_.size()) {
            for (const std::uint32_t slot : inner_slots_) {
                frame_.get()->slots[slot] = Value::unset();
            }
            std::vector<Value> values;
            for (const std::uint32_t slot : shared_slots_) {
                values.push_back(frame_.get()->slots[slot]);
            }
            evaluator_.run_block(block_, frame_.get(), out_);
            for (std::size_t i = 0; i < values.size(); ++i) {
                frame_.get()->slots[shared_slots_[i]] = std::move(values[i]);
            }
            return;
        }
        const Argument& a = arguments_[variable];
        const Value values = evaluator_.statement_value(a.value, frame_.get());
        const Sequence sequence(values, evaluator_, c_.where());
        for (std::size_t i = 0; i < sequence.size(); ++i) {
            evaluator_.check_stop(c_.where());
            const Evaluator::DynamicMark mark(evaluator_);
            if (a.name != kNoSymbol) {
                evaluator_.assign(a, sequence.at(i), *frame_.get());
            }
            run(variable + 1);
        }
    }

    const ModuleContext& c_;
    Evaluator& evaluator_;
    const BlockId block_;
    const std::span<const Argument> arguments_;
    const Evaluator::BlockFrame frame_;
    std::vector<std::uint32_t> inner_slots_;   ///< Of the block's own variables, which each round begins without.
    std::vector<std::uint32_t> shared_slots_;  ///< Of the loop's variables that the block gives other values.
    Nodes& out_;
};

template <Operation kOperation>
void run_for(const ModuleContext& c, Nodes& out) {
    Nodes children;
    ForLoop(c, children).run();
    if (kOperation == Operation::Group) {
        group(c, children, out);
    } else {
        combine(c, kOperation, children, out);
    }
}

void run_let(const ModuleContext& c, Nodes& out) {
    Evaluator& evaluator = c.evaluator;
    const BlockId block = c.instantiation.children;
    Nodes children;
    {
        const Evaluator::BlockFrame frame(evaluator, block, c.frame);
        for (const Argument& a : evaluator.program().arguments_of(c.instantiation)) {
            Value value = evaluator.statement_value(a.value, frame.get());
            if (a.name == kNoSymbol) {
                evaluator.warn(a.where, fmt::format("Assignment without variable name {}", value.echo_text()));
            } else if (is_repeated(evaluator.program().arguments_of(c.instantiation), a)) {
                evaluator.warn(a.where, fmt::format("Ignoring duplicate variable assignment \"{}\" = {}",
                                                    evaluator.name(a.name), value.echo_text()));
            } else {
                evaluator.assign(a, std::move(value), *frame.get());
            }
        }
        evaluator.run_block(block, frame.get(), children);
    }
    group(c, children, out);
}

void run_assign(const ModuleContext& c, Nodes& out) {
    c.evaluator.emit(Severity::Deprecated, c.where(),
                     "The assign() module will be removed in future releases. Use a regular assignment instead.");
    run_let(c, out);
}

void run_group(const ModuleContext& c, Nodes& out) {
    const ModuleArguments arguments(c, {});
    combine(c, Operation::Group, c.children(), out);
}

/// A group of the children, or nothing where there are none.
void pass_children(const ModuleContext& c, Nodes& out) {
    const Program& program = c.evaluator.program();
    if (program.blocks[c.instantiation.children].instantiations.count != 0) {
        group(c, c.children(), out);
    }
}

void run_echo(const ModuleContext& c, Nodes& out) {
    c.evaluator.echo_statement(c.instantiation, c.frame);
    pass_children(c, out);
}

void run_assert(const ModuleContext& c, Nodes& out) {
    c.evaluator.assert_statement(c.instantiation, c.frame);
    pass_children(c, out);
}

/// The children that a call of children() names.
class ChildSelection {
  public:
    ChildSelection(const ModuleContext& c, const ModuleCall& call)
        : c_(c), call_(call), count_(c.evaluator.child_count(call)) {}

    void add(const Value& which) {
        constexpr std::uint32_t kMostOfRange = 10'000;  // OpenSCAD's limit.
        if (which.is_number()) {
            add_index(which.number());
        } else if (which.is_vector()) {
            list_ = true;
            for (const Value& e : which.elements()) {
                if (e.is_number()) {
                    add_index(e.number());
                } else {
                    bad_type(e);
                }
            }
        } else if (which.is_range()) {
            list_ = true;
            const std::uint32_t steps = which.range().count();
            if (steps >= kMostOfRange) {
                c_.warn(fmt::format("Bad range parameter for children: too many elements ({})", steps));
                return;
            }
            for (std::uint32_t i = 0; i < steps; ++i) {
                add_index(which.range().at(i));
            }
        } else {
            bad_type(which);
        }
    }

    void run(Nodes& out) const {
        Nodes nodes;
        for (const std::size_t i : indices_) {
            c_.evaluator.run_child(call_, i, nodes);
        }
        if (!indices_.empty() || list_) {
            group(c_, nodes, out);
        }
    }

  private:
    void add_index(double index) {
        const double whole = std::trunc(index);
        if (whole >= 0 && whole < static_cast<double>(count_)) {
            indices_.push_back(static_cast<std::size_t>(whole));
        } else {
            c_.warn(fmt::format("Children index ({}) out of bounds ({} children)", number_text(whole), count_));
        }
    }

    void bad_type(const Value& which) const {
        c_.warn(fmt::format("Bad parameter type ({}) for children, only accept: empty, number, vector, range",
                            which.echo_text()));
    }

    const ModuleContext& c_;
    const ModuleCall& call_;
    const std::size_t count_;
    std::vector<std::size_t> indices_;
    bool list_ = false;  ///< A list or range that names no child is an empty operand; a number that names none is none.
};

void run_children(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<std::string_view, 1> kParameters{"index"};
    c.expect_no_children();
    const ModuleArguments arguments(c, kParameters);
    const ModuleCall* const call = c.frame->module;
    if (call == nullptr) {
        return;
    }
    if (arguments.given("index")) {
        ChildSelection selection(c, *call);
        selection.add(arguments["index"]);
        selection.run(out);
        return;
    }
    // Without children, too: an operand that is empty is not the same as no operand.
    Nodes nodes;
    if (c.evaluator.child_count(*call) != 0) {
        c.evaluator.children_of(*call->instantiation, call->caller, nodes);
    }
    group(c, nodes, out);
}

constexpr std::array kControl{
    ModuleEntry{"for", run_for<Operation::Group>},
    ModuleEntry{"intersection_for", run_for<Operation::Intersection>},
    ModuleEntry{"let", run_let},
    ModuleEntry{"assign", run_assign},
    ModuleEntry{"group", run_group},
    ModuleEntry{"children", run_children},
    ModuleEntry{"echo", run_echo},
    ModuleEntry{"assert", run_assert},
};

}  // namespace

std::span<const ModuleEntry> control_modules() {
    return kControl;
}

}  // namespace csg::scad
