// Calls. Those in tail position take the place of the function that they end: they use no stack.
#include <algorithm>

#include "csg/scad/machine/compiler.h"
#include "csg/scad/machine/machine.h"
#include "csg/scad/value/object.h"

namespace csg::scad {

/// What a call of no certain function calls, with its arguments in place.
struct Evaluator::Callee {
    const Code* code = nullptr;
    std::uint32_t builtin = kNone;  ///< In place of `code`: index of the target.
    const Frame* frame = nullptr;
    UnitId unit = kNone;  ///< Of a function of a used file, in whose frame it runs.
    Value function;       ///< Keeps a function value alive.
    Value self;           ///< Of a method: what `this` is; else undef.
    Symbol name = kNoSymbol;
    std::uint32_t entry = 0;
    Value* values = nullptr;  ///< Of the first parameters.
    std::size_t count = 0;
    std::vector<Value> bound;  ///< They lie here where they had to be sorted.
    Dynamics dynamics;         ///< `$` arguments.
};

CompilerHost Evaluator::compiler_host() {
    return {p_,
            r_,
            is_undef_,
            len_,
            [this](Symbol text) { return text_constant(text); },
            r_.late_captures,
            [this](const SourceRange& where) { check_stack(where, "evaluating an expression", kNoSymbol, 0); }};
}

const Code& Evaluator::compile_function(std::uint32_t id) {
    resolver_.need_function(id);
    const FunctionDefinition& f = p_.functions[id];
    const CompilerHost host = compiler_host();
    codes_.push_back(Compiler(host, r_.locals_of_function[id]).function(p_.parameters_of(f), f.body, kNone));
    function_codes_[id] = &codes_.back();
    return codes_.back();
}

const Code& Evaluator::literal_code(ExprId literal) {
    const std::uint32_t number = r_.of_expression[literal];
    if (number >= literal_codes_.size()) {
        literal_codes_.resize(r_.literals.size());
    }
    if (literal_codes_[number] == nullptr) {
        const LiteralInfo& info = r_.literals[number];
        const CompilerHost host = compiler_host();
        codes_.push_back(Compiler(host, info.locals)
                             .function(p_.arguments_of(p_[literal]), p_[literal].operand(0), info.this_parameter));
        literal_codes_[number] = &codes_.back();
    }
    return *literal_codes_[number];
}

const Code& Evaluator::statement_code(ExprId id) {
    if (const Code* const code = statement_codes_.find(id)) {
        return *code;
    }
    const CompilerHost host = compiler_host();
    codes_.push_back(Compiler(host, r_.statement_locals).statement(id));
    statement_codes_.enter(id, codes_.back());
    return codes_.back();
}

Value Evaluator::statement_value(ExprId id, const Frame* frame) {
    if (id == kNone) {
        return {};
    }
    const Expr& e = p_[id];
    switch (e.kind) {  // What most arguments of modules are needs no code.
        case ExprKind::Boolean:
            return e.number != 0;
        case ExprKind::Number:
            return e.number;
        case ExprKind::String:
            return text_constant(e.name);
        case ExprKind::Unary:
            if (e.op == Operator::Negate && is_simple_literal(p_, id)) {
                return -p_[e.operand(0)].number;
            }
            break;
        case ExprKind::Identifier: {
            Value value = variable(r_.variables[r_.of_expression[id]], frame, nullptr);
            return value.is_unset() ? unknown_variable(id) : value;
        }
        default:
            break;
    }
    check_stack(e.where, "evaluating an expression", kNoSymbol, 0);
    const Code& code = statement_code(id);
    Activation activation(*this, code, stack_.mark().top, 0, frame, &e.where, kNoSymbol);
    return run(activation, 0);
}

Value Evaluator::call_function(const Instruction& i, Activation& caller) {
    const DefinitionRef definition = r_.calls[i.a].function;
    const SourceRange& where = p_[i.e].where;
    const Symbol called = p_.functions[definition.id].name;
    check_stack(where, "calling function", called, kCallReserve);
    check_stop(where);
    const Code& code = function_code(definition.id);
    Activation callee(*this, code, caller.registers + i.b, code.parameters.size(), nullptr, &where, called);
    callee.frame = frame_of(definition, caller.frame);
    return run(callee, code.entries[i.c]);
}

/// The frame that a function runs in.
const Frame* Evaluator::frame_of(const DefinitionRef& definition, const Frame* caller) {
    return definition.hops == kUsedUnit ? enter_unit(definition.unit) : outward(caller, definition.hops);
}

/// To the register of the callee: the function value; undef where a definition or a built-in is meant. False (and a
/// warning) where there is nothing to call.
bool Evaluator::find_callee(const Instruction& i, Activation& a) {
    for (std::uint32_t at = i.a;; at = r_.calls[at].next) {
        const CallTarget& target = r_.calls[at];
        if (target.kind == CallTarget::Kind::Variable) {
            Value value = variable(target.variable, a.frame, &a);
            if (value.is_function()) {
                a.registers[i.b] = std::move(value);
                return true;
            }
            continue;
        }
        a.registers[i.b] = Value();
        if (target.kind == CallTarget::Kind::Unknown) {
            warn_no_function(i.e);
            return false;
        }
        return true;
    }
}

void Evaluator::warn_no_function(ExprId call) {
    warn(p_[call].where, fmt::format("Ignoring unknown function '{}'", name(p_[p_[call].operand(0)].name)));
}

void Evaluator::warn_no_callee(const Instruction& i, const Value& value) {
    warn(p_[i.e].where, fmt::format("Can't call function on {}", type_name(value.type())));
}

/// Takes over the callee's register and those of the arguments.
Evaluator::Callee Evaluator::prepare(const Instruction& i, Activation& caller) {
    Callee callee;
    const Expr& e = p_[i.e];
    if (p_[e.operand(0)].kind == ExprKind::Identifier) {
        callee.name = p_[e.operand(0)].name;
    }
    callee.values = caller.registers + i.b + 1;
    callee.count = i.c;
    callee.function = std::move(caller.registers[i.b]);
    if (!callee.function.is_function()) {
        std::uint32_t at = i.a;
        while (r_.calls[at].kind == CallTarget::Kind::Variable) {
            at = r_.calls[at].next;
        }
        if (r_.calls[at].kind == CallTarget::Kind::Builtin) {
            callee.builtin = at;
            return callee;
        }
        const DefinitionRef definition = r_.calls[at].function;
        callee.code = &function_code(definition.id);
        callee.unit = definition.hops == kUsedUnit ? definition.unit : kNone;
        callee.frame = callee.unit == kNone ? outward(caller.frame, definition.hops) : nullptr;
    } else {
        if (callee.function.function().is_method()) {
            const auto& method = static_cast<const MethodObject&>(callee.function.function());
            callee.self = method.self;
            callee.function = Value(method.function);
        }
        auto& closure = static_cast<Closure&>(callee.function.function());
        if (closure.code == nullptr) {
            closure.code = &literal_code(closure.literal);
        }
        callee.code = closure.code;
        callee.frame = closure.frame;
    }
    bind(callee, p_.arguments_of(e), e.where);
    return callee;
}

/// Sorts the arguments by the parameters they are for.
void Evaluator::bind(Callee& callee, std::span<const Argument> arguments, const SourceRange& where) {
    const auto parameters = callee.code->parameters;
    if (arguments.size() <= parameters.size() &&
        std::all_of(arguments.begin(), arguments.end(), [](const Argument& a) { return a.name == kNoSymbol; })) {
        callee.entry = callee.code->entries[arguments.size()];
        return;
    }
    callee.bound.assign(parameters.size(), Value::unset());
    bind_arguments(arguments, callee.values, parameters, where, callee.bound.data(), callee.dynamics);
    callee.values = callee.bound.data();
    callee.count = parameters.size();
}

/// Once a callee's parameters have their registers: what depends on whom it calls.
void Evaluator::enter(Activation& a, Callee& callee) {
    for (std::size_t i = callee.count; i < a.code->parameters.size(); ++i) {
        a.registers[i] = Value::unset();
    }
    a.function = std::move(callee.function);
    a.frame = callee.unit == kNone ? callee.frame : enter_unit(callee.unit);
    if (callee.self.is_object()) {
        a.registers[a.code->this_parameter] = std::move(callee.self);
    }
    for (auto& [slot, value] : callee.dynamics) {
        bind_dynamic(slot, std::move(value));
    }
}

Value Evaluator::call_any(const Instruction& i, Activation& caller) {
    Callee callee = prepare(i, caller);
    if (callee.builtin != kNone) {
        return call_builtin(i.e, callee.builtin, {callee.values, callee.count});
    }
    const SourceRange& where = p_[i.e].where;
    check_stack(where, "calling function", callee.name, kCallReserve);
    check_stop(where);
    const bool sorted = !callee.bound.empty();
    Activation activation(*this, *callee.code, caller.registers + i.b + 1, sorted ? 0 : callee.count, nullptr, &where,
                          callee.name);
    if (sorted) {
        std::move(callee.bound.begin(), callee.bound.end(), activation.registers);
    }
    enter(activation, callee);
    return run(activation, callee.entry);
}

/// A tail call: `a` becomes the callee's, which begins at `entry`. False where a built-in gave the `result`.
bool Evaluator::replace(const Instruction& i, Activation& a, unsigned tail_calls, std::uint32_t& entry, Value& result) {
    const SourceRange& where = p_[i.e].where;
    const auto check = [&](Symbol called) {
        if (tail_calls >= request_.limits.tail_calls) {
            fail(where,
                 fmt::format("Recursion detected calling function '{}'", called == kNoSymbol ? "" : name(called)));
        }
        check_stop(where);
    };
    if (i.op == Opcode::TailFunction) {
        const DefinitionRef definition = r_.calls[i.a].function;
        const Symbol called = p_.functions[definition.id].name;
        check(called);
        const Code& code = function_code(definition.id);
        a.replace(code, a.registers + i.b, code.parameters.size());
        a.step.where = &where;
        a.step.name = called;
        a.frame = frame_of(definition, a.frame);  // `$` variables of the caller stay, as in OpenSCAD.
        a.function = Value();
        entry = code.entries[i.c];
        return true;
    }
    Callee callee = prepare(i, a);
    if (callee.builtin != kNone) {
        result = call_builtin(i.e, callee.builtin, {callee.values, callee.count});
        return false;
    }
    check(callee.name);
    if (callee.bound.empty()) {
        a.replace(*callee.code, callee.values, callee.count);
    } else {
        a.replace(*callee.code, callee.bound);
    }
    a.step.where = &where;
    a.step.name = callee.name;
    entry = callee.entry;
    enter(a, callee);
    return true;
}

Value Evaluator::call_builtin(ExprId call, std::uint32_t target, std::span<const Value> arguments) {
    const CallTarget& builtin = r_.calls[target];
    call_ = call;
    return builtin.builtin(builtin.name, arguments, host_);
}

}  // namespace csg::scad
