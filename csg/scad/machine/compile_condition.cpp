// Conditions: comparisons, `!`, `&&` and `||` become jumps.
#include "csg/scad/machine/compiler.h"

namespace csg::scad {

namespace {

/// Jump where nothing is to be asked but the truth of a value.
Opcode jump_of(Operator op) {
    switch (op) {
        case Operator::Equal:
            return Opcode::JumpEqual;
        case Operator::NotEqual:
            return Opcode::JumpNotEqual;
        case Operator::Less:
            return Opcode::JumpLess;
        case Operator::LessEqual:
            return Opcode::JumpLessEqual;
        case Operator::Greater:
            return Opcode::JumpGreater;
        case Operator::GreaterEqual:
            return Opcode::JumpGreaterEqual;
        default:
            return Opcode::JumpTrue;
    }
}

}  // namespace

void Compiler::branch(ExprId id, bool when, Jumps& jumps) {
    while (id != kNone && p_[id].kind == ExprKind::Unary && p_[id].op == Operator::Not) {
        when = !when;
        id = p_[id].operand(0);
    }
    const Temporaries temporaries(*this);
    if (id != kNone && p_[id].kind == ExprKind::Binary && p_[id].links < kLongChain && branch_binary(id, when, jumps)) {
        return;
    }
    const Operand value = operand(id);
    jumps.push_back(emit({.op = Opcode::JumpTrue, .flag = when, .a = word(value)}));
}

/// False where it is no such operator.
bool Compiler::branch_binary(ExprId id, bool when, Jumps& jumps) {
    const Expr& e = p_[id];
    host_.check_stack(e.where);
    if (e.op == Operator::And || e.op == Operator::Or) {
        const bool decides = e.op == Operator::Or;  // What the left operand must be for the right one not to count.
        Jumps decided;
        branch(e.operand(0), decides, when == decides ? jumps : decided);
        branch(e.operand(1), when, jumps);
        land(decided);
        return true;
    }
    const Opcode jump = jump_of(e.op);
    if (jump == Opcode::JumpTrue) {
        return false;
    }
    const Operand left = operand(e.operand(0));
    const Operand right = operand(e.operand(1));
    jumps.push_back(emit(
        {.op = jump, .flag = when, .a = word(left), .b = word(right), .c = static_cast<std::uint32_t>(e.op), .e = id}));
    return true;
}

void Compiler::truth(ExprId id, Register target) {
    Jumps no;
    branch(id, false, no);
    choose(no, true, target);
}

void Compiler::truth_of_link(const Expr& e, Operand left, Register target) {
    const bool decides = e.op == Operator::Or;
    Jumps jumps{emit({.op = Opcode::JumpTrue, .flag = decides, .a = word(left)})};
    branch(e.operand(1), decides, jumps);
    choose(jumps, !decides, target);
}

/// `value` here, the other truth where the jumps land.
void Compiler::choose(const Jumps& otherwise, bool value, Register target) {
    move(constant(value), target);
    const std::uint32_t end = emit({.op = Opcode::Jump});
    land(otherwise);
    move(constant(!value), target);
    land({end});
}

}  // namespace csg::scad
