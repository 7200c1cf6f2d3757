// Blocks, instantiations and user-defined modules.
#include <algorithm>

#include "base/stop.h"
#include "csg/scad/builtin/builtin_modules.h"
#include "csg/scad/machine/evaluator.h"
#include "csg/scad/syntax/argument_roles.h"

namespace csg::scad {

namespace {

/// Keeps the list of the modules that run.
class ModuleName {
  public:
    ModuleName(FunctionHost& host, std::string_view name) : host_(host) { host.module_names.push_back(name); }
    ~ModuleName() { host_.module_names.pop_back(); }
    ModuleName(const ModuleName&) = delete;
    ModuleName& operator=(const ModuleName&) = delete;

  private:
    FunctionHost& host_;
};

}  // namespace

void Evaluator::echo_statement(const Instantiation& i, const Frame* frame) {
    std::vector<Value> values;
    for (const Argument& a : p_.arguments_of(i)) {
        values.push_back(statement_value(a.value, frame));
    }
    echo(p_.arguments_of(i), values.data());
}

void Evaluator::assert_statement(const Instantiation& i, const Frame* frame) {
    const auto [condition, message] = assertion_of(p_, p_.arguments_of(i));
    if (condition != nullptr && statement_value(condition->value, frame)) {
        return;
    }
    const Value text = message == nullptr ? Value() : statement_value(message->value, frame);
    fail_assertion(i.where, condition == nullptr ? kNone : condition->value, message == nullptr ? nullptr : &text);
}

void Evaluator::assign(const Argument& a, Value value, const Frame& frame) {
    const auto index = index_of(a);
    if (dynamic_name(a.name)) {
        bind_dynamic(r_.argument_slots[index], std::move(value));
    } else {
        frame.slots[r_.argument_slots[index]] = std::move(value);
    }
}

void Evaluator::run_assignments(const Block& block, const Frame& frame) {
    for (const Argument& a : p_.assignments_of(block)) {
        const auto index = static_cast<std::uint32_t>(&a - p_.assignments.data());
        const std::uint32_t slot = r_.assignment_slots[index];
        const Step step(*this,
                        {.kind = ActiveStep::Kind::Assignment, .where = &a.where, .name = a.name, .assignment = index});
        try {
            Value value = statement_value(a.value, &frame);
            if (dynamic_name(a.name)) {
                bind_dynamic(slot, std::move(value));
            } else {
                frame.slots[slot] = std::move(value);
            }
        } catch (const ValueLimit& limit) {
            fail_limit(a.where, limit);
        } catch (const base::Stopped&) {
            fail_stopped(a.where);
        } catch (const std::bad_alloc&) {
            fail_out_of_memory(a.where);
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

void Evaluator::children_of(const Instantiation& i, const Frame* frame, Nodes& out) {
    if (i.children != kNone) {
        const BlockFrame inner(*this, i.children, frame);
        run_block(i.children, inner.get(), out);
    }
}

std::size_t Evaluator::child_count(const ModuleCall& call) const {
    const BlockId children = call.instantiation == nullptr ? kNone : call.instantiation->children;
    return children == kNone ? 0 : p_.blocks[children].instantiations.count;
}

void Evaluator::run_child(const ModuleCall& call, std::size_t index, Nodes& out) {
    const BlockId children = call.instantiation->children;
    const BlockFrame inner(*this, children, call.caller);
    const Block& block = p_.blocks[children];
    run_assignments(block, *inner.get());
    instantiate(p_.instantiations_of(block)[index], inner.get(), out);
}

void Evaluator::instantiate_if(const Instantiation& first, const Frame* frame, Nodes& out) {
    // `else if` after `else if`: each is a group in that of the one before it.
    std::vector<const Instantiation*> chain{&first};
    BlockId branch = kNone;
    for (;;) {
        const Instantiation& i = *chain.back();
        const auto arguments = p_.arguments_of(i);
        const bool chosen = !arguments.empty() && statement_value(arguments[0].value, frame);
        branch = chosen ? i.children : i.otherwise;
        if (chosen || branch == kNone || !p_.is_else_if(p_.blocks[branch])) {
            break;
        }
        const Instantiation& next = p_.instantiations_of(p_.blocks[branch])[0];
        has_root_modifier_ |= next.modifiers.root;
        chain.push_back(&next);
    }
    Nodes nodes;
    if (branch != kNone) {
        const BlockFrame inner(*this, branch, frame);
        run_block(branch, inner.get(), nodes);
    } else {
        chain.pop_back();  // The last makes nothing.
    }
    for (auto i = chain.rbegin(); i != chain.rend(); ++i) {
        if (request_.lazy_union && modifiers(**i) == csg::Modifiers{}) {
            continue;
        }
        const NodeId group = builder_.combine(Operation::Group, nodes, location((*i)->where), modifiers(**i));
        nodes.assign(1, group);
        note_statement(**i);
    }
    out.insert(out.end(), nodes.begin(), nodes.end());
}

csg::Modifiers Evaluator::modifiers(const Instantiation& i) const {
    return {i.modifiers.background, i.modifiers.highlight, i.modifiers.root};
}

void Evaluator::count_nodes(const Instantiation& i, std::size_t made) {
    if (made != 0) {
        note_statement(i);
    }
    if ((nodes_ += made) > request_.limits.nodes) {
        fail(i.where, fmt::format("The model has more than {} nodes", request_.limits.nodes));
    }
}

void Evaluator::instantiate(const Instantiation& i, const Frame* frame, Nodes& out) {
    if (i.modifiers.disabled) {
        return;
    }
    check_stop(i.where);
    const std::size_t before = out.size();
    const auto index = static_cast<std::size_t>(&i - p_.instantiations.data());
    const Step step(*this, {.where = &i.where, .name = i.is_if ? kNoSymbol : i.name});
    try {
        const ModuleTarget& target = r_.module_of_instantiation[index];
        if (i.is_if) {
            check_stack(i.where, "calling module", i.name, kCallReserve);
            instantiate_if(i, frame, out);
        } else if (target.user.id != kNone) {
            instantiate_user(i, target.user, frame, out);
        } else if (target.builtin != nullptr) {
            check_stack(i.where, "calling module", i.name, kCallReserve);
            const DynamicMark mark(*this);
            target.builtin({*this, i, frame, modifiers(i)}, out);
        } else {
            warn(i.where, fmt::format("Ignoring unknown module '{}'", name(i.name)));
        }
    } catch (const ValueLimit& limit) {
        fail_limit(i.where, limit);
    } catch (const base::Stopped&) {
        fail_stopped(i.where);
    } catch (const std::bad_alloc&) {
        fail_out_of_memory(i.where);
    }
    has_root_modifier_ |= i.modifiers.root;
    count_nodes(i, out.size() - before);
}

/// Values of the arguments, which see the caller's variables.
void Evaluator::bind_module(const Instantiation& i, std::span<const Argument> parameters, const Frame* frame,
                            Value* slots, Dynamics& dynamics, std::vector<std::pair<Symbol, Value>>& others) {
    const auto arguments = p_.arguments_of(i);
    const ValueStack::Region values(stack_, arguments.size());
    for (std::size_t k = 0; k < arguments.size(); ++k) {
        values.data()[k] = statement_value(arguments[k].value, frame);
    }
    bind_arguments(arguments, values.data(), parameters, i.where, slots, dynamics, &others);
}

/// Values of the parameters that have no argument.
void Evaluator::bind_defaults(std::span<const Argument> parameters, const Frame* defining, Value* slots) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (!slots[i].is_unset()) {
            continue;
        }
        if (r_.repeated_parameters[index_of(parameters[i])]) {  // One variable; its second value may be but a default.
            const auto first = std::find_if(parameters.begin(), parameters.end(),
                                            [&](const Argument& p) { return p.name == parameters[i].name; });
            slots[i] = slots[static_cast<std::size_t>(first - parameters.begin())];
            continue;
        }
        slots[i] = statement_value(parameters[i].value, defining);
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (dynamic_name(parameters[i].name)) {
            bind_dynamic(r_.argument_slots[index_of(parameters[i])], slots[i]);
        }
    }
}

void Evaluator::instantiate_user(const Instantiation& i, const DefinitionRef& definition, const Frame* frame,
                                 Nodes& out) {
    resolver_.need_module(definition.id);
    const ModuleDefinition& m = p_.modules[definition.id];
    check_stack(m.where, "calling module", m.name, kCallReserve);
    const auto parameters = p_.parameters_of(m);
    const DynamicMark mark(*this);
    const Frame* const defining =
        definition.hops == kUsedUnit ? enter_unit(definition.unit) : outward(frame, definition.hops);
    const ModuleCall call{&i, frame};
    const ValueStack::Region values(stack_, parameters.size());
    const ModuleInfo& info = r_.module_info[definition.id];
    std::vector<std::pair<Symbol, Value>> others;
    Dynamics dynamics;
    bind_module(i, parameters, frame, values.data(), dynamics, others);
    const ModuleName module_name(host_, name(m.name));
    for (auto& [slot, value] : dynamics) {
        bind_dynamic(slot, std::move(value));
    }
    bind_defaults(parameters, defining, values.data());
    bind_dynamic(parent_modules_index_, static_cast<double>(host_.module_names.size()));
    const std::uint32_t count = r_.frame_slots[m.body];
    const ValueStack::Region slots(stack_, count == kNone ? 0 : count);
    Frame body{defining, slots.data(), &call};
    // A body without a frame of its own still needs one that says whose children are meant.
    if (count == kNone) {
        body = {defining->outer, defining->slots, &call};
    }
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        if (!dynamic_name(parameters[k].name)) {
            body.slots[r_.argument_slots[index_of(parameters[k])]] = values.data()[k];
        }
    }
    for (auto& [other, value] : others) {
        for (const auto& [known, slot] : info.other_arguments) {
            if (known == other) {
                body.slots[slot] = std::move(value);
                break;
            }
        }
    }
    for (const std::uint32_t assignment : info.literal_parameters) {
        const Argument& a = p_.assignments[assignment];
        warn(a.where, fmt::format("Parameter \"{}\" is overwritten with a literal", name(a.name)));
    }
    const Block& block = p_.blocks[m.body];
    run_assignments(block, body);
    Nodes nodes;
    {
        const Step step(*this, {.kind = ActiveStep::Kind::CallOf,
                                .where = &m.where,
                                .name = request_.trace_parameters ? m.name : kNoSymbol,
                                .parameters = parameters,
                                .values = values.data()});
        for (const Instantiation& statement : p_.instantiations_of(block)) {
            instantiate(statement, &body, nodes);
        }
    }
    out.push_back(builder_.combine(Operation::Group, nodes, location(i.where), modifiers(i)));
}

}  // namespace csg::scad
