// Calls of functions. Calls in tail position loop; they use no stack.
#include <algorithm>

#include "csg/scad/evaluator.h"
#include "csg/scad/object.h"

namespace csg::scad {

/// A user function or a function value, ready to be called.
struct Evaluator::Callee {
    std::span<const Argument> parameters;
    ExprId body = kNone;
    std::uint32_t locals = 0;
    const Frame* frame = nullptr;
    UnitId unit = kNone;  ///< Of a function of a used file, in whose frame it runs.
    Value closure;        ///< Keeps a function value alive.
    Value self;           ///< Of a method: what `this` is; else undef.
    std::uint32_t this_parameter = kNone;
    BuiltinFunction builtin = nullptr;
    Symbol name = kNoSymbol;

    [[nodiscard]] Scope scope(Value* slots) const {
        return {slots, frame, closure.is_function() ? &static_cast<Closure&>(closure.function()) : nullptr};
    }
};

/// Once the arguments are known (in `slots`), which see the caller's `$` variables.
void Evaluator::enter(Callee& callee, Value* slots) {
    if (callee.unit != kNone) {
        callee.frame = enter_unit(callee.unit);
    }
    if (callee.self.is_object()) {
        slots[callee.this_parameter] = callee.self;
    }
}

/// False (and a warning) where there is nothing to call.
bool Evaluator::find_callee(const Expr& e, ExprId id, Scope& scope, Callee& callee) {
    const Expr& target = p_[e.operand(0)];
    Value value;
    if (target.kind == ExprKind::Identifier) {
        callee.name = target.name;
        for (std::uint32_t i = r_.of_expression[id]; i != kNone && !value.is_function(); i = r_.calls[i].next) {
            const CallTarget& t = r_.calls[i];
            switch (t.kind) {
                case CallTarget::Kind::Variable:
                    value = variable(t.variable, scope);
                    break;
                case CallTarget::Kind::Function: {
                    const DefinitionRef definition = t.function;
                    resolver_.need_function(definition.id);
                    const FunctionDefinition& f = p_.functions[definition.id];
                    callee.parameters = p_.parameters_of(f);
                    callee.body = f.body;
                    callee.locals = r_.locals_of_function[definition.id];
                    callee.unit = definition.hops == kUsedUnit ? definition.unit : kNone;
                    callee.frame = callee.unit == kNone ? outward(scope.frame, definition.hops) : nullptr;
                    callee.closure = Value();
                    return true;
                }
                case CallTarget::Kind::Builtin:
                    callee.builtin = t.builtin;
                    return true;
                case CallTarget::Kind::Unknown:
                    warn(e.where, fmt::format("Ignoring unknown function '{}'", name(target.name)));
                    return false;
            }
        }
    } else {
        value = evaluate(e.operand(0), scope);
        if (!value.is_function()) {
            warn(e.where, fmt::format("Can't call function on {}", type_name(value.type())));
            return false;
        }
    }
    if (value.function().is_method()) {
        const auto& method = static_cast<const MethodObject&>(value.function());
        callee.self = method.self;
        value = Value(method.function);
    } else {
        callee.self = Value();
    }
    const auto& closure = static_cast<Closure&>(value.function());
    const Expr& literal = p_[closure.literal];
    callee.parameters = p_.arguments_of(literal);
    callee.body = literal.operand(0);
    const LiteralInfo& info = r_.literals[r_.of_expression[closure.literal]];
    callee.locals = info.locals;
    callee.this_parameter = info.this_parameter;
    callee.frame = closure.frame;
    callee.unit = kNone;
    callee.closure = std::move(value);
    return true;
}

/// Values of the arguments go to the slots of the parameters they are for; parameters without one stay unset.
/// Named arguments that are for no parameter go to `others`.
void Evaluator::bind_arguments(std::span<const Argument> arguments, std::span<const Argument> parameters,
                               const SourceRange& where, Scope& caller, Value* slots,
                               std::vector<std::pair<Symbol, Value>>* others) {
    if (arguments.size() <= parameters.size() &&
        std::all_of(arguments.begin(), arguments.end(), [](const Argument& a) { return a.name == kNoSymbol; })) {
        for (std::size_t i = 0; i < arguments.size(); ++i) {  // Nothing to find out.
            slots[i] = evaluate(arguments[i].value, caller);
        }
        return;
    }
    std::uint64_t by_name = 0;  // Of the first 64 parameters.
    std::uint64_t by_position = 0;
    const auto bit = [](std::size_t i) { return i < 64 ? std::uint64_t{1} << i : 0; };
    std::size_t position = 0;
    bool too_many = false;
    std::vector<std::pair<std::uint32_t, Value>> dynamics;
    std::vector<Symbol> unknown;
    for (const Argument& a : arguments) {
        Value value = evaluate(a.value, caller);
        if (a.name == kNoSymbol) {
            while (position < parameters.size() && (by_name & bit(position)) != 0) {
                ++position;
            }
            if (position < parameters.size()) {
                by_position |= bit(position);
                slots[position++] = std::move(value);
            } else if (!too_many && request_.check_parameters) {
                too_many = true;
                warn(where, "Too many unnamed arguments supplied");
            }
            continue;
        }
        std::size_t i = 0;
        while (i < parameters.size() && parameters[i].name != a.name) {
            ++i;
        }
        if (i < parameters.size()) {
            if ((by_name & bit(i)) != 0) {
                warn(where, fmt::format("argument \"{}\" supplied more than once", name(a.name)));
            } else if ((by_position & bit(i)) != 0) {
                warn(where, fmt::format("argument \"{}\" overrides positional argument", name(a.name)));
            }
            by_name |= bit(i);
            slots[i] = std::move(value);
        } else if (dynamic_name(a.name)) {
            const std::uint32_t slot = r_.argument_slots[index_of(a)];
            for (const auto& d : dynamics) {
                if (d.first == slot) {
                    warn(where, fmt::format("argument \"{}\" supplied more than once", name(a.name)));
                }
            }
            dynamics.emplace_back(slot, std::move(value));
        } else {
            const bool again = std::find(unknown.begin(), unknown.end(), a.name) != unknown.end();
            if (again || request_.check_parameters) {
                warn(where, again ? fmt::format("argument \"{}\" supplied more than once", name(a.name))
                                  : fmt::format("variable \"{}\" not specified as parameter", name(a.name)));
            }
            unknown.push_back(a.name);
            if (others != nullptr) {
                others->emplace_back(a.name, std::move(value));
            }
        }
    }
    for (auto& [slot, value] : dynamics) {
        pending_dynamics_.emplace_back(slot, std::move(value));
    }
}

void Evaluator::bind_defaults(std::span<const Argument> parameters, Scope& defining, Value* slots) {
    for (auto& [slot, value] : pending_dynamics_) {
        bind_dynamic(slot, std::move(value));
    }
    pending_dynamics_.clear();
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
        slots[i] = parameters[i].value == kNone ? Value() : evaluate(parameters[i].value, defining);
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (dynamic_name(parameters[i].name)) {
            bind_dynamic(r_.argument_slots[index_of(parameters[i])], slots[i]);
        }
    }
}

Value Evaluator::call_builtin(const Expr& e, BuiltinFunction function, Scope& scope) {
    const auto arguments = p_.arguments_of(e);
    const std::string& function_name = name(p_[e.operand(0)].name);
    const bool silent = function == is_undef_;
    const ValueStack::Region values(stack_, arguments.size());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const ExprId a = arguments[i].value;
        if (silent && p_[a].kind == ExprKind::Identifier) {
            values.data()[i] = variable(r_.variables[r_.of_expression[a]], scope);
            if (values.data()[i].is_unset()) {
                values.data()[i] = Value();
            }
        } else {
            values.data()[i] = evaluate(a, scope);
        }
    }
    call_where_ = e.where;
    call_arguments_ = arguments;
    return function(function_name, {values.data(), arguments.size()}, host_);
}

Value Evaluator::call(ExprId id, Scope& caller) {
    const Expr& e = p_[id];
    Callee callee;
    if (!find_callee(e, id, caller, callee)) {
        return {};
    }
    if (callee.builtin != nullptr) {
        return call_builtin(e, callee.builtin, caller);
    }
    check_stack(e.where, "calling function", callee.name, kCallReserve);
    check_stop(e.where);
    const DynamicMark mark(*this);
    ValueStack::Region slots(stack_, callee.locals);
    Step step(*this, {ActiveStep::Kind::CalledBy, &e.where, callee.name, 0, {}, nullptr, nullptr});
    bind_arguments(p_.arguments_of(e), callee.parameters, e.where, caller, slots.data());
    enter(callee, slots.data());
    Scope scope = callee.scope(slots.data());
    bind_defaults(callee.parameters, scope, slots.data());
    ExprId body = callee.body;
    for (unsigned tail_calls = 0; body != kNone;) {
        const Expr& b = p_[body];
        if (b.kind == ExprKind::Conditional) {
            body = is_true(b.operand(0), scope) ? b.operand(1) : b.operand(2);
        } else if (b.kind == ExprKind::Let) {
            bind_let(p_.arguments_of(b), scope);
            body = b.operand(0);
        } else if (b.kind == ExprKind::Assert) {
            check_assertion(p_.arguments_of(b), b.where, scope);
            body = b.operand(0);
        } else if (b.kind == ExprKind::Echo) {
            echo(p_.arguments_of(b), scope);
            body = b.operand(0);
        } else if (b.kind == ExprKind::Call) {
            Callee next;
            if (!find_callee(b, body, scope, next)) {
                return {};
            }
            if (next.builtin != nullptr) {
                return call_builtin(b, next.builtin, scope);
            }
            if (++tail_calls >= request_.limits.tail_calls) {
                fail(b.where, fmt::format("Recursion detected calling function '{}'",
                                          next.name == kNoSymbol ? "" : name(next.name)));
            }
            check_stop(b.where);
            ValueStack::Region fresh(stack_, next.locals);
            bind_arguments(p_.arguments_of(b), next.parameters, b.where, scope, fresh.data());
            callee = std::move(next);
            step.change(b.where, callee.name);
            slots.replace(fresh);
            enter(callee, slots.data());  // `$` variables of the caller stay, as in OpenSCAD.
            scope = callee.scope(slots.data());
            bind_defaults(callee.parameters, scope, slots.data());
            body = callee.body;
        } else {
            return evaluate(body, scope);
        }
    }
    return {};
}

}  // namespace csg::scad
