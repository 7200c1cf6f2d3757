// let, assert and echo.
#include <algorithm>

#include "csg/scad/machine/compiler.h"
#include "csg/scad/syntax/argument_roles.h"

namespace csg::scad {

bool Compiler::binds_dynamic(std::span<const Argument> arguments) const {
    return std::any_of(arguments.begin(), arguments.end(),
                       [&](const Argument& a) { return a.name != kNoSymbol && dynamic_name(a.name); });
}

void Compiler::let(const Expr& e, Register target) {
    const auto arguments = p_.arguments_of(e);
    const bool dynamic = binds_dynamic(arguments);
    const Register mark = dynamic ? take() : kNone;
    if (dynamic) {
        emit({.op = Opcode::MarkDynamic, .target = mark});
    }
    bind(arguments);
    into(e.operand(0), target);
    if (dynamic) {
        emit({.op = Opcode::RestoreDynamic, .a = mark});
    }
}

void Compiler::bind(std::span<const Argument> arguments) {
    for (const Argument& a : arguments) {
        const Temporaries temporaries(*this);
        const auto index = static_cast<std::uint32_t>(argument_index(a));
        if (a.name == kNoSymbol || is_repeated(arguments, a)) {
            const Operand value = operand(a.value);
            emit({.op = Opcode::WarnAssignment, .a = word(value), .b = index});
        } else if (dynamic_name(a.name)) {
            const Operand value = operand(a.value);
            emit({.op = Opcode::BindDynamic, .target = slot_of(a), .a = word(value)});
        } else {
            into(a.value, slot_of(a));
            if (host_.late_captures) {
                emit({.op = Opcode::Settle, .a = slot_of(a)});
            }
        }
    }
}

void Compiler::assertion(ExprId id) {
    const auto [condition, message] = assertion_of(p_, p_.arguments_of(p_[id]));
    const Temporaries temporaries(*this);
    Jumps holds;
    if (condition != nullptr) {
        branch(condition->value, true, holds);
    }
    const Operand text = message == nullptr ? constant({}) : operand(message->value);
    emit({.op = Opcode::FailAssert,
          .flag = message != nullptr,
          .a = word(text),
          .b = condition == nullptr ? kNone : condition->value,
          .e = id});
    land(holds);
}

void Compiler::echo(ExprId id) {
    const auto arguments = p_.arguments_of(p_[id]);
    const Temporaries temporaries(*this);
    const Register first = next_;
    for (const Argument& a : arguments) {
        into(a.value, take());
    }
    emit({.op = Opcode::Echo, .a = first, .b = static_cast<std::uint32_t>(arguments.size()), .e = id});
}

}  // namespace csg::scad
