// Whole functions and statements; what all parts of the compiler use.
#include "csg/scad/machine/compiler.h"

#include <algorithm>

#include "csg/scad/machine/operators.h"

namespace csg::scad {

Compiler::Compiler(const CompilerHost& host, std::uint32_t locals)
    : host_(host), p_(host.program), r_(host.resolution), locals_(locals), next_(locals) {
    code_.registers = locals;
}

Code Compiler::statement(ExprId e) {
    emit({.op = Opcode::Return, .a = word(operand(e)), .e = e});
    return finish();
}

Code Compiler::function(std::span<const Argument> parameters, ExprId body, std::uint32_t this_parameter) {
    code_.parameters = parameters;
    code_.first_parameter = parameters.empty() ? 0 : static_cast<std::uint32_t>(argument_index(parameters[0]));
    code_.this_parameter = this_parameter;
    for (Register i = 0; i < parameters.size(); ++i) {
        code_.entries.push_back(here());
        const std::uint32_t given = emit({.op = Opcode::JumpSet, .a = i});
        if (r_.repeated_parameters[argument_index(parameters[i])]) {  // Its second value may be but a default.
            const auto first = std::find_if(parameters.begin(), parameters.end(),
                                            [&](const Argument& p) { return p.name == parameters[i].name; });
            move(operand_of(static_cast<Register>(first - parameters.begin())), i);
        } else {
            into(parameters[i].value, i);
        }
        land({given});
    }
    code_.entries.push_back(here());
    for (Register i = 0; i < parameters.size(); ++i) {
        if (dynamic_name(parameters[i].name)) {
            emit({.op = Opcode::BindDynamic, .target = slot_of(parameters[i]), .a = word(operand_of(i))});
        }
    }
    tail(body);
    return finish();
}

Code Compiler::finish() {
    code_.instructions.shrink_to_fit();
    code_.constants.shrink_to_fit();
    return std::move(code_);
}

Register Compiler::take(std::uint32_t count) {
    const Register first = next_;
    next_ += count;
    code_.registers = std::max(code_.registers, next_);
    return first;
}

Operand Compiler::constant(Value value) {
    code_.constants.push_back(std::move(value));
    return constant_operand(static_cast<std::uint32_t>(code_.constants.size() - 1));
}

std::uint32_t Compiler::emit(const Instruction& i) {
    code_.instructions.push_back(i);
    return here() - 1;
}

void Compiler::land(const Jumps& jumps) {
    for (const std::uint32_t jump : jumps) {
        code_.instructions[jump].target = here();
    }
}

bool Compiler::dynamic_name(Symbol name) const {
    return r_.dynamic_of_symbol[name] != kNone;
}

std::size_t Compiler::argument_index(const Argument& a) const {
    return static_cast<std::size_t>(&a - p_.arguments.data());
}

std::uint32_t Compiler::slot_of(const Argument& a) const {
    return r_.argument_slots[argument_index(a)];
}

Value Compiler::literal(const Expr& e) const {
    switch (e.kind) {
        case ExprKind::Boolean:
            return e.number != 0;
        case ExprKind::Number:
            return e.number;
        case ExprKind::String:
            return host_.text(e.name);
        case ExprKind::Unary: {
            std::string problem;
            return apply_unary(e.op, p_[e.operand(0)].number, problem);
        }
        default:
            return {};
    }
}

bool Compiler::is_constant_list(ExprId id) const {
    return p_[id].kind == ExprKind::Vector && r_.of_expression[id] != kNone;
}

Value Compiler::constant_list(ExprId id) const {
    std::vector<Value> elements;
    for (const ExprId part : p_.elements_of(p_[id])) {
        elements.push_back(p_[part].kind == ExprKind::Vector ? constant_list(part) : literal(p_[part]));
    }
    return Value::lasting(elements);
}

}  // namespace csg::scad
