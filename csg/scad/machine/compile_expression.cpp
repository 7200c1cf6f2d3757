// Expressions but conditions, lists and calls.
#include <algorithm>
#include <numbers>

#include "csg/scad/machine/compiler.h"

namespace csg::scad {

namespace {

Opcode opcode_of(Operator op) {
    switch (op) {
        case Operator::Equal:
            return Opcode::Equal;
        case Operator::NotEqual:
            return Opcode::NotEqual;
        case Operator::Less:
            return Opcode::Less;
        case Operator::LessEqual:
            return Opcode::LessEqual;
        case Operator::Greater:
            return Opcode::Greater;
        case Operator::GreaterEqual:
            return Opcode::GreaterEqual;
        case Operator::Add:
            return Opcode::Add;
        case Operator::Subtract:
            return Opcode::Subtract;
        case Operator::Multiply:
            return Opcode::Multiply;
        case Operator::Divide:
            return Opcode::Divide;
        case Operator::Modulo:
            return Opcode::Modulo;
        default:
            return Opcode::Binary;
    }
}

/// One more than the index of what `.x` and the like name; 0 for other members.
std::uint8_t component_of(std::string_view member) {
    for (const std::string_view set : {"xyzw", "rgba"}) {
        if (member.size() == 1 && set.find(member) != std::string_view::npos) {
            return static_cast<std::uint8_t>(set.find(member) + 1);
        }
    }
    return 0;
}

bool is_link(ExprKind kind) {
    return kind == ExprKind::Binary || kind == ExprKind::Index || kind == ExprKind::Member;
}

}  // namespace

void Compiler::move(Operand from, Register target) {
    if (from != operand_of(target)) {
        emit({.op = Opcode::Move, .target = target, .a = word(from)});
    }
}

/// Whether an expression is a constant or a register as it stands.
bool Compiler::lies_ready(ExprId id) const {
    if (id == kNone || is_simple_literal(p_, id) || is_constant_list(id)) {
        return true;
    }
    if (p_[id].kind != ExprKind::Identifier) {
        return false;
    }
    const VariableRef& ref = r_.variables[r_.of_expression[id]];
    return ref.place == Place::Pi ||
           (ref.place == Place::Local && std::find(carried_.begin(), carried_.end(), ref.slot) == carried_.end());
}

Operand Compiler::operand(ExprId id, Register hint) {
    if (id == kNone) {
        return constant({});
    }
    const Expr& e = p_[id];
    if (is_simple_literal(p_, id)) {
        return constant(literal(e));
    }
    if (is_constant_list(id)) {
        return constant(constant_list(id));
    }
    if (lies_ready(id)) {
        const VariableRef& ref = r_.variables[r_.of_expression[id]];
        return ref.place == Place::Local ? operand_of(ref.slot) : constant(std::numbers::pi);
    }
    const Register target = hint != kNone && is_temporary(hint) ? hint : take();
    into(id, target);
    return operand_of(target);
}

void Compiler::into(ExprId id, Register target) {
    Jumps ends;
    while (id != kNone && p_[id].kind == ExprKind::Conditional) {
        Jumps otherwise;
        branch(p_[id].operand(0), false, otherwise);
        into(p_[id].operand(1), target);
        ends.push_back(emit({.op = Opcode::Jump}));
        land(otherwise);
        id = p_[id].operand(2);
    }
    if (id == kNone) {
        move(constant({}), target);
    } else {
        into_one(id, target);
    }
    land(ends);
}

void Compiler::into_one(ExprId id, Register target) {
    const Expr& e = p_[id];
    host_.check_stack(e.where);
    const Temporaries temporaries(*this);
    switch (e.kind) {
        case ExprKind::Undef:
        case ExprKind::Boolean:
        case ExprKind::Number:
        case ExprKind::String:
            move(operand(id), target);
            return;
        case ExprKind::Identifier:
            variable(id, target);
            return;
        case ExprKind::Range: {
            const Register first = take(3);
            range(id, first);
            emit({.op = Opcode::Range, .target = target, .a = first, .e = id});
            return;
        }
        case ExprKind::Unary:
            unary(id, target);
            return;
        case ExprKind::Binary:
        case ExprKind::Index:
        case ExprKind::Member:
            chain(id, target);
            return;
        case ExprKind::Call:
            call(id, target, false);
            return;
        case ExprKind::Let:
            let(e, target);
            return;
        case ExprKind::Assert:
            assertion(id);
            into(e.operand(0), target);
            return;
        case ExprKind::Echo:
            echo(id);
            into(e.operand(0), target);
            return;
        case ExprKind::Function:
            emit({.op = Opcode::MakeClosure, .target = target, .e = id});
            return;
        default:
            vector(id, target);
    }
}

/// What ends a function: the last instruction returns, or calls in its place.
void Compiler::tail(ExprId id) {
    while (id != kNone) {
        const Expr& e = p_[id];
        switch (e.kind) {
            case ExprKind::Conditional: {
                host_.check_stack(e.where);
                Jumps otherwise;
                branch(e.operand(0), false, otherwise);
                tail(e.operand(1));
                land(otherwise);
                id = e.operand(2);
                continue;
            }
            case ExprKind::Let:  // `$` variables hold until the function returns.
                bind(p_.arguments_of(e));
                id = e.operand(0);
                continue;
            case ExprKind::Assert:
                assertion(id);
                id = e.operand(0);
                continue;
            case ExprKind::Echo:
                echo(id);
                id = e.operand(0);
                continue;
            case ExprKind::Call:
                call(id, take(), true);
                return;
            default:
                break;
        }
        break;
    }
    const Temporaries temporaries(*this);
    emit({.op = Opcode::Return, .a = word(operand(id)), .e = id});
}

void Compiler::variable(ExprId id, Register target) {
    const std::uint32_t index = r_.of_expression[id];
    const VariableRef& ref = r_.variables[index];
    switch (ref.place) {
        case Place::Local:
            move(operand_of(ref.slot), target);
            if (std::find(carried_.begin(), carried_.end(), ref.slot) != carried_.end()) {
                emit({.op = Opcode::CheckSet, .target = target, .e = id});
            }
            return;
        case Place::Pi:
            move(constant(std::numbers::pi), target);
            return;
        case Place::Block:
            emit({.op = Opcode::LoadBlock, .target = target, .a = index, .b = ref.hops, .c = ref.slot, .e = id});
            return;
        case Place::Dynamic:
            emit({.op = Opcode::LoadDynamic, .target = target, .a = index, .b = ref.slot, .e = id});
            return;
        default:
            emit({.op = Opcode::LoadVariable, .target = target, .a = index, .e = id});
    }
}

void Compiler::unary(ExprId id, Register target) {
    const Expr& e = p_[id];
    if (is_simple_literal(p_, id)) {
        move(operand(id), target);
        return;
    }
    if (e.op == Operator::Not) {
        truth(id, target);
        return;
    }
    const Operand a = operand(e.operand(0), target);
    emit({.op = Opcode::Unary, .flag = static_cast<std::uint8_t>(e.op), .target = target, .a = word(a), .e = id});
}

/// Chains (`a + b + c`, `a[0][1].x`) grow to the left without brackets: a long one takes no stack.
void Compiler::chain(ExprId id, Register target) {
    if (p_[id].links < kLongChain) {
        if (p_[id].op == Operator::And || p_[id].op == Operator::Or) {
            truth(id, target);
        } else if (!index_of_block(id, target)) {
            link(id, operand(p_[id].operand(0), target), target);
        }
        return;
    }
    std::vector<ExprId> links;
    ExprId first = id;
    for (; is_link(p_[first].kind); first = p_[first].operand(0)) {
        links.push_back(first);
    }
    Operand left = operand(first);
    const Register between = take();
    for (auto at = links.rbegin(); at != links.rend(); ++at) {
        const Register to = *at == id ? target : between;
        link(*at, left, to);
        left = operand_of(to);
    }
}

/// `name[i]` where `name` is a variable of a block and `i` takes no instruction. False for other expressions.
bool Compiler::index_of_block(ExprId id, Register target) {
    const Expr& e = p_[id];
    if (e.kind != ExprKind::Index || p_[e.operand(0)].kind != ExprKind::Identifier || !lies_ready(e.operand(1))) {
        return false;
    }
    const std::uint32_t index = r_.of_expression[e.operand(0)];
    const VariableRef& ref = r_.variables[index];
    constexpr std::uint32_t kMostHops = 255;
    if (ref.place != Place::Block || ref.hops > kMostHops) {
        return false;
    }
    emit({.op = Opcode::IndexBlock,
          .flag = static_cast<std::uint8_t>(ref.hops),
          .target = target,
          .a = index,
          .b = word(operand(e.operand(1))),
          .c = ref.slot,
          .e = e.operand(0)});
    return true;
}

void Compiler::link(ExprId id, Operand left, Register target) {
    const Expr& e = p_[id];
    const Temporaries temporaries(*this);
    if (e.kind == ExprKind::Member) {
        emit({.op = Opcode::Member,
              .flag = component_of(p_.symbols.text(e.name)),
              .target = target,
              .a = word(left),
              .b = e.name,
              .e = id});
        return;
    }
    if (e.op == Operator::And || e.op == Operator::Or) {
        truth_of_link(e, left, target);
        return;
    }
    const Operand right = operand(e.operand(1));
    emit({.op = e.kind == ExprKind::Index ? Opcode::Index : opcode_of(e.op),
          .flag = static_cast<std::uint8_t>(e.op),
          .target = target,
          .a = word(left),
          .b = word(right),
          .e = id});
}

void Compiler::range(ExprId id, Register first) {
    const Expr& e = p_[id];
    into(e.operand(0), first);
    if (e.operand(1) == kNone) {
        move(constant(1.0), first + 1);
    } else {
        into(e.operand(1), first + 1);
    }
    into(e.operand(2), first + 2);
}

}  // namespace csg::scad
