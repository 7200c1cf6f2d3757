// Lists and list comprehensions.
#include <algorithm>

#include "csg/scad/machine/compiler.h"

namespace csg::scad {

namespace {
constexpr std::size_t kFewElements = 8;  ///< Elements that get a register each.
constexpr std::uint32_t kLoop = 4;       ///< Registers of a loop.
}  // namespace

/// A list, or an element of one that stands alone.
void Compiler::vector(ExprId id, Register target) {
    if (p_[id].kind != ExprKind::Vector) {
        gather(id, target);
        return;
    }
    if (is_constant_list(id)) {
        move(constant(constant_list(id)), target);
        return;
    }
    const auto parts = p_.elements_of(p_[id]);
    if (parts.size() > kFewElements ||
        std::any_of(parts.begin(), parts.end(), [&](ExprId part) { return is_element_kind(p_[part].kind); })) {
        gather(id, target);
        return;
    }
    const Register first = next_;
    for (const ExprId part : parts) {
        into(part, take());
    }
    emit({.op = Opcode::List, .target = target, .a = first, .b = static_cast<std::uint32_t>(parts.size())});
}

/// A list whose elements are counted when they are known.
void Compiler::gather(ExprId id, Register target) {
    const Register begin = take();
    emit({.op = Opcode::BeginList, .target = begin});
    if (p_[id].kind == ExprKind::Vector) {
        for (const ExprId part : p_.elements_of(p_[id])) {
            element(part);
        }
    } else {
        element(id);
    }
    emit({.op = Opcode::EndList, .target = target, .a = begin});
}

void Compiler::element(ExprId id) {
    const Temporaries temporaries(*this);
    Jumps ends;
    while (id != kNone && p_[id].kind == ExprKind::ListIf) {
        Jumps otherwise;
        branch(p_[id].operand(0), false, otherwise);
        element(p_[id].operand(1));
        ends.push_back(emit({.op = Opcode::Jump}));
        land(otherwise);
        id = p_[id].operand(2);
    }
    if (id != kNone) {
        element_but_if(id);
    }
    land(ends);
}

void Compiler::element_but_if(ExprId id) {
    const Expr& e = p_[id];
    host_.check_stack(e.where);
    const bool dynamic = (e.kind == ExprKind::ListFor || e.kind == ExprKind::ListForC || e.kind == ExprKind::ListLet) &&
                         (binds_dynamic(p_.arguments_of(e)) || binds_dynamic(p_.update_of(e)));
    const Register mark = dynamic ? take() : kNone;
    if (dynamic) {
        emit({.op = Opcode::MarkDynamic, .target = mark});
    }
    switch (e.kind) {
        case ExprKind::ListFor:
            loop(id, p_.arguments_of(e));
            break;
        case ExprKind::ListForC:
            loop_for_c(id);
            break;
        case ExprKind::ListLet:
            bind(p_.arguments_of(e));
            element(e.operand(0));
            break;
        case ExprKind::ListEach: {
            const ExprId body = e.operand(0);
            const bool many = body != kNone && is_element_kind(p_[body].kind);
            const Operand value = operand(body);
            emit({.op = many ? Opcode::AppendEachOf : Opcode::AppendEach, .a = word(value), .e = id});
            break;
        }
        default: {
            const Operand value = operand(id);
            const bool taken = !is_constant(value) && is_temporary(index_of(value));
            emit({.op = taken ? Opcode::AppendTaken : Opcode::Append, .a = taken ? index_of(value) : word(value)});
        }
    }
    if (dynamic) {
        emit({.op = Opcode::RestoreDynamic, .a = mark});
    }
}

void Compiler::loop(ExprId id, std::span<const Argument> left) {
    if (left.empty()) {
        element(p_[id].operand(0));
        return;
    }
    const Argument& a = left[0];
    const Temporaries temporaries(*this);
    const Register state = take(kLoop);
    const bool dynamic = a.name != kNoSymbol && dynamic_name(a.name);
    const Register variable = a.name == kNoSymbol || dynamic ? take() : slot_of(a);
    std::uint32_t start = 0;
    if (a.value != kNone && p_[a.value].kind == ExprKind::Range) {
        range(a.value, state);
        start = emit({.op = Opcode::ForRange, .a = state, .b = id, .c = variable, .e = a.value});
    } else {
        const Operand values = operand(a.value, state);
        start = emit({.op = Opcode::ForValues, .a = state, .b = word(values), .c = variable, .e = id});
    }
    const std::uint32_t body = here();
    if (dynamic) {
        emit({.op = Opcode::BindDynamic, .target = slot_of(a), .a = word(operand_of(variable))});
    }
    loop(id, left.subspan(1));
    emit({.op = Opcode::ForNext, .target = body, .a = state, .c = variable, .e = id});
    land({start});
}

void Compiler::loop_for_c(ExprId id) {
    const Expr& e = p_[id];
    bind(p_.arguments_of(e));
    const std::size_t carried = carried_.size();
    if (r_.of_expression[id] != kNone) {
        for (const CarriedVariable& variable : r_.carried[r_.of_expression[id]]) {
            emit({.op = Opcode::LoadCarried, .target = variable.slot, .a = variable.outer});
            carried_.push_back(variable.slot);
        }
    }
    const Register round = take();
    move(constant(0.0), round);
    const std::uint32_t begin = here();
    Jumps end;
    branch(e.operand(1), false, end);
    emit({.op = Opcode::ForRound, .a = round, .e = id});
    element(e.operand(0));
    bind(p_.update_of(e));
    emit({.op = Opcode::Jump, .target = begin});
    land(end);
    carried_.resize(carried);
}

}  // namespace csg::scad
