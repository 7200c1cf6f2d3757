// Blocks, instantiations and user-defined modules.
#include <algorithm>

#include "csg/scad/builtin_modules.h"
#include "csg/scad/evaluator.h"
#include "csg/scad/expression_text.h"

namespace csg::scad {

Value Evaluator::statement_value(ExprId e, const Frame* frame) {
    const ValueStack::Region locals(stack_, r_.statement_locals);
    Scope scope{locals.data(), frame, nullptr};
    return evaluate(e, scope);
}

void Evaluator::assign(const Argument& a, Value value, const Frame& frame) {
    const auto index = static_cast<std::size_t>(&a - p_.arguments.data());
    if (is_dynamic(name(a.name))) {
        bind_dynamic(r_.argument_slots[index], std::move(value));
    } else {
        frame.slots[r_.argument_slots[index]] = std::move(value);
    }
}

void Evaluator::run_assignments(const Block& block, const Frame& frame) {
    for (const Argument& a : p_.assignments_of(block)) {
        const std::uint32_t slot = r_.assignment_slots[static_cast<std::size_t>(&a - p_.assignments.data())];
        try {
            Value value = statement_value(a.value, &frame);
            if (is_dynamic(name(a.name))) {
                bind_dynamic(slot, std::move(value));
            } else {
                frame.slots[slot] = std::move(value);
            }
        } catch (EvaluationError& error) {
            error.trace.push_back({Severity::Trace, a.where, fmt::format("assignment to \"{}\"", name(a.name))});
            throw;
        }
    }
}

void Evaluator::run_block(BlockId id, const Frame* frame, Nodes& out) {
    const Block& block = p_.blocks[id];
    run_assignments(block, *frame);
    for (const Instantiation& i : p_.instantiations_of(block)) {
        instantiate(i, frame, out);
    }
}

void Evaluator::with_frame(BlockId block, const Frame* outer, const std::function<void(const Frame*)>& body) {
    const DynamicMark mark(*this);
    if (r_.frame_slots[block] == kNone) {
        body(outer);
        return;
    }
    const ValueStack::Region slots(stack_, r_.frame_slots[block]);
    const Frame frame{outer, slots.data(), outer->module};
    body(&frame);
}

void Evaluator::children_of(const Instantiation& i, const Frame* frame, Nodes& out) {
    if (i.children != kNone) {
        with_frame(i.children, frame, [&](const Frame* inner) { run_block(i.children, inner, out); });
    }
}

std::size_t Evaluator::child_count(const ModuleCall& call) const {
    const BlockId children = call.instantiation == nullptr ? kNone : call.instantiation->children;
    return children == kNone ? 0 : p_.blocks[children].instantiations.count;
}

void Evaluator::run_child(const ModuleCall& call, std::size_t index, Nodes& out) {
    const BlockId children = call.instantiation->children;
    with_frame(children, call.caller, [&](const Frame* inner) {
        const Block& block = p_.blocks[children];
        run_assignments(block, *inner);
        instantiate(p_.instantiations_of(block)[index], inner, out);
    });
}

void Evaluator::instantiate_if(const Instantiation& first, const Frame* frame, Nodes& out) {
    const auto arguments = p_.arguments_of(first);
    const bool chosen = !arguments.empty() && statement_value(arguments[0].value, frame);
    const BlockId branch = chosen ? first.children : first.otherwise;
    if (branch == kNone) {
        return;
    }
    Nodes nodes;
    with_frame(branch, frame, [&](const Frame* inner) { run_block(branch, inner, nodes); });
    out.push_back(builder_.combine(Operation::Group, nodes, location(first.where), modifiers(first)));
}

csg::Modifiers Evaluator::modifiers(const Instantiation& i) const {
    return {i.modifiers.background, i.modifiers.highlight, i.modifiers.root};
}

void Evaluator::instantiate(const Instantiation& i, const Frame* frame, Nodes& out) {
    if (i.modifiers.disabled) {
        return;
    }
    check_stop(i.where);
    const std::size_t before = out.size();
    const auto index = static_cast<std::size_t>(&i - p_.instantiations.data());
    try {
        if (i.is_if) {
            check_stack(i.where, "calling module", i.name);
            instantiate_if(i, frame, out);
        } else if (const DefinitionRef& user = r_.module_of_instantiation[index].user; user.id != kNone) {
            check_stack(i.where, "calling module", i.name);
            instantiate_user(i, user, frame, out);
        } else if (const BuiltinModule builtin = find_builtin_module(name(i.name))) {
            check_stack(i.where, "calling module", i.name);
            const DynamicMark mark(*this);
            builtin({*this, i, frame, modifiers(i)}, out);
        } else {
            warn(i.where, fmt::format("Ignoring unknown module '{}'", name(i.name)));
        }
    } catch (EvaluationError& error) {
        if (!i.is_if) {
            error.trace.push_back({Severity::Trace, i.where, fmt::format("called by '{}'", name(i.name))});
        }
        throw;
    }
    if (i.modifiers.root && out.size() > before) {
        mark_root(out.back());
    }
    if ((nodes_ += out.size() - before) > request_.limits.nodes) {
        fail(i.where, fmt::format("The model has more than {} nodes", request_.limits.nodes));
    }
}

void Evaluator::instantiate_user(const Instantiation& i, const DefinitionRef& definition, const Frame* frame,
                                 Nodes& out) {
    const ModuleDefinition& m = p_.modules[definition.id];
    const auto parameters = p_.parameters_of(m);
    const Frame* const defining =
        definition.hops == kUsedUnit ? unit_frame(definition.unit) : outward(frame, definition.hops);
    const DynamicMark mark(*this);
    const ModuleCall call{&i, frame};
    const ValueStack::Region values(stack_, parameters.size());
    {
        const ValueStack::Region locals(stack_, r_.statement_locals);
        Scope caller{locals.data(), frame, nullptr};
        bind_arguments(p_.arguments_of(i), parameters, i.where, caller, values.data());
    }
    Nodes nodes;
    host_.module_names.push_back(name(m.name));
    try {
        const ValueStack::Region locals(stack_, r_.statement_locals);
        Scope scope{locals.data(), defining, nullptr};
        bind_defaults(parameters, scope, values.data());
        bind_dynamic(children_index_, static_cast<double>(child_count(call)));
        bind_dynamic(parent_modules_index_, static_cast<double>(host_.module_names.size()));
        const std::uint32_t count = r_.frame_slots[m.body];
        const ValueStack::Region slots(stack_, count == kNone ? 0 : count);
        Frame body{defining, slots.data(), &call};
        // A body without a frame of its own still needs one that says whose children are meant.
        if (count == kNone) {
            body = {defining->outer, defining->slots, &call};
        }
        for (std::size_t k = 0; k < parameters.size(); ++k) {
            if (!is_dynamic(name(parameters[k].name))) {
                body.slots[r_.argument_slots[static_cast<std::size_t>(&parameters[k] - p_.arguments.data())]] =
                    values.data()[k];
            }
        }
        run_block(m.body, &body, nodes);
    } catch (EvaluationError& error) {
        std::string text;
        for (std::size_t k = 0; k < parameters.size(); ++k) {
            text +=
                fmt::format("{}{} = {}", k == 0 ? "" : ", ", name(parameters[k].name), values.data()[k].echo_text());
        }
        error.trace.push_back({Severity::Trace, m.where, fmt::format("call of '{}({})'", name(m.name), text)});
        host_.module_names.pop_back();
        throw;
    }
    host_.module_names.pop_back();
    out.push_back(builder_.combine(Operation::Group, nodes, location(i.where), modifiers(i)));
}

const Frame* Evaluator::unit_frame(UnitId id) {
    UnitFrame& unit = units_[id];
    if (!unit.ready) {
        unit.ready = true;  // Before its assignments: units may use each other in circles.
        const BlockId block = p_.units[id].block;
        unit.slots.assign(r_.frame_slots[block], Value::unset());
        unit.frame = {nullptr, unit.slots.data(), nullptr};
        const DynamicMark mark(*this);
        run_assignments(p_.blocks[block], unit.frame);
    }
    return &unit.frame;
}

}  // namespace csg::scad
