// List comprehensions, and what a for goes through.
#include "csg/scad/evaluator.h"
#include "csg/scad/sequence.h"

namespace csg::scad {

void Evaluator::collect(ExprId id, Scope& scope, std::vector<Value>& out) {
    while (id != kNone) {
        const Expr& e = p_[id];
        switch (e.kind) {
            case ExprKind::ListFor: {
                check_stack(e.where, "evaluating an expression", kNoSymbol, 0);
                const DynamicMark mark(*this);
                collect_for(e, p_.arguments_of(e), scope, out);
                return;
            }
            case ExprKind::ListForC: {
                check_stack(e.where, "evaluating an expression", kNoSymbol, 0);
                const DynamicMark mark(*this);
                collect_for_c(id, scope, out);
                return;
            }
            case ExprKind::ListIf:
                id = is_true(e.operand(0), scope) ? e.operand(1) : e.operand(2);
                continue;
            case ExprKind::ListLet: {
                check_stack(e.where, "evaluating an expression", kNoSymbol, 0);
                const DynamicMark mark(*this);
                bind_let(p_.arguments_of(e), scope);
                collect(e.operand(0), scope, out);
                return;
            }
            case ExprKind::ListEach: {
                std::vector<Value> inner;
                collect(e.operand(0), scope, inner);
                for (const Value& value : inner) {
                    collect_each(value, e.where, out);
                }
                return;
            }
            default:
                out.push_back(evaluate(id, scope));
                return;
        }
    }
}

void Evaluator::collect_each(const Value& value, const SourceRange& where, std::vector<Value>& out) {
    if (value.is_vector()) {
        out.insert(out.end(), value.elements().begin(), value.elements().end());
    } else if (value.is_range() || value.is_string()) {
        const Sequence sequence(value, *this, where);
        for (std::size_t i = 0; i < sequence.size(); ++i) {
            out.push_back(sequence.at(i));
        }
    } else if (!value.is_undef()) {
        out.push_back(value);
    }
}

void Evaluator::collect_for(const Expr& e, std::span<const Argument> left, Scope& scope, std::vector<Value>& out) {
    if (left.empty()) {
        collect(e.operand(0), scope, out);
        return;
    }
    const Value values = evaluate(left[0].value, scope);
    const Sequence sequence(values, *this, e.where);
    if (out.empty() && left.size() == 1 && !is_element_kind(p_[e.operand(0)].kind)) {
        out.reserve(sequence.size());  // One element each.
    }
    for (std::size_t i = 0; i < sequence.size(); ++i) {
        if (i % 1024 == 1023) {
            check_stop(e.where);
            if (live_elements() + out.size() > request_.limits.list_elements) {
                fail(e.where, fmt::format("Lists hold more than {} elements", request_.limits.list_elements));
            }
        }
        if (left[0].name != kNoSymbol) {
            bind_local(left[0], sequence.at(i), scope);
        }
        collect_for(e, left.subspan(1), scope, out);
    }
}

void Evaluator::collect_for_c(ExprId id, Scope& scope, std::vector<Value>& out) {
    constexpr unsigned kMaxRounds = 1'000'000;  // OpenSCAD's limit.
    const Expr& e = p_[id];
    bind_let(p_.arguments_of(e), scope);
    if (r_.of_expression[id] != kNone) {
        for (const CarriedVariable& carried : r_.carried[r_.of_expression[id]]) {
            scope.locals[carried.slot] = variable(r_.variables[carried.outer], scope);
        }
    }
    for (unsigned round = 0; is_true(e.operand(1), scope); ++round) {
        if (round == kMaxRounds) {
            fail(e.where, "For loop counter exceeded limit");
        }
        check_stop(e.where);
        collect(e.operand(0), scope, out);
        bind_let(p_.update_of(e), scope);
    }
}

}  // namespace csg::scad
