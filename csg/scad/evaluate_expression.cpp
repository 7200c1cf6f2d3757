// Evaluation of expressions but calls and lists.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "csg/scad/annotations.h"
#include "csg/scad/evaluator.h"
#include "csg/scad/expression_text.h"
#include "csg/scad/object.h"
#include "csg/scad/operators.h"

namespace csg::scad {

const Frame* Evaluator::outward(const Frame* frame, std::uint32_t hops) const {
    for (; hops > 0; --hops) {
        frame = frame->outer;
    }
    return frame;
}

/// The value of `id` where it lies, if it lies somewhere; else in `temporary`. What is seen by an expression does not
/// change while it is worked out, so the reference holds until its end.
/// Inline by force: it is small, called everywhere, and compilers think it large.
[[gnu::always_inline]] inline const Value& Evaluator::operand(ExprId id, Scope& scope, Value& temporary) {
    const Expr& e = p_[id];
    if (e.kind == ExprKind::Number) {
        temporary = e.number;
        return temporary;
    }
    if (e.kind == ExprKind::Identifier) {
        const VariableRef& ref = r_.variables[r_.of_expression[id]];
        const Value* found = nullptr;
        if (ref.place == Place::Local) {
            found = &scope.locals[ref.slot];
        } else if (ref.place == Place::Capture) {
            found = &scope.closure->captures[ref.slot];
        } else if (ref.place == Place::Block) {
            found = &outward(scope.frame, ref.hops)->slots[ref.slot];
        }
        if (found != nullptr && !found->is_unset()) {
            return *found;
        }
    } else if (e.kind == ExprKind::String) {
        return text_constant(e.name);
    }
    temporary = evaluate(id, scope);
    return temporary;
}

Value Evaluator::variable(const VariableRef& ref, const Scope& scope) const {
    switch (ref.place) {
        case Place::Children:
            return scope.frame == nullptr || scope.frame->module == nullptr
                       ? Value::unset()
                       : Value(static_cast<double>(child_count(*scope.frame->module)));
        case Place::Pi:
            return std::numbers::pi;
        case Place::Local:
            return scope.locals[ref.slot];
        case Place::Capture: {
            const Value& value = scope.closure->captures[ref.slot];
            if (value.is_unset()) {
                ++scope.closure->references;
                return Value(scope.closure);
            }
            return value;
        }
        case Place::Dynamic:
            return dynamic_[ref.slot];
        case Place::Block: {
            const Value& value = outward(scope.frame, ref.hops)->slots[ref.slot];
            return value.is_unset() && ref.next != kNone ? variable(r_.variables[ref.next], scope) : value;
        }
        case Place::Unknown:
            break;
    }
    return Value::unset();
}

Value Evaluator::variable_or_warn(ExprId id, const Scope& scope) {
    Value value = variable(r_.variables[r_.of_expression[id]], scope);
    if (value.is_unset()) {
        warn(p_[id].where, fmt::format("Ignoring unknown variable \"{}\"", name(p_[id].name)));
        return {};
    }
    return value;
}

Value Evaluator::evaluate(ExprId id, Scope& scope) {
    while (id != kNone && p_[id].kind == ExprKind::Conditional) {
        id = is_true(p_[id].operand(0), scope) ? p_[id].operand(1) : p_[id].operand(2);
    }
    if (id == kNone) {
        return {};
    }
    const Expr& e = p_[id];
    check_stack(e.where, "evaluating an expression", kNoSymbol, 0);
    switch (e.kind) {
        case ExprKind::Undef:
            return {};
        case ExprKind::Boolean:
            return e.number != 0;
        case ExprKind::Number:
            return e.number;
        case ExprKind::String:
            return text_constant(e.name);
        case ExprKind::Identifier:
            return variable_or_warn(id, scope);
        case ExprKind::Vector:
            return evaluate_vector(id, scope);
        case ExprKind::Range:
            return evaluate_range(e, scope);
        case ExprKind::Unary:
            return evaluate_unary(e, scope);
        case ExprKind::Binary:
        case ExprKind::Index:
        case ExprKind::Member:
            return evaluate_chain(e, scope);
        case ExprKind::Conditional:
            return {};  // See above.
        case ExprKind::Call:
            return call(id, scope);
        case ExprKind::Let: {
            const DynamicMark mark(*this);
            bind_let(p_.arguments_of(e), scope);
            return evaluate(e.operand(0), scope);
        }
        case ExprKind::Assert:
            check_assertion(p_.arguments_of(e), e.where, scope);
            return evaluate(e.operand(0), scope);
        case ExprKind::Echo:
            echo(p_.arguments_of(e), scope);
            return evaluate(e.operand(0), scope);
        case ExprKind::Function:
            return make_closure(id, scope);
        default:
            return evaluate_vector(id, scope);
    }
}

const Value& Evaluator::text_constant(Symbol text) {
    if (text >= strings_.size()) {
        strings_.resize(p_.symbols.size(), Value::unset());  // Room is kept: what is there stays where it is.
    }
    Value& value = strings_[text];
    if (value.is_unset()) {
        value = name(text);
    }
    return value;
}

/// A list, or an element of one that stands alone.
Value Evaluator::evaluate_vector(ExprId id, Scope& scope) {
    const Expr& e = p_[id];
    if (e.kind != ExprKind::Vector) {
        std::vector<Value> elements;
        collect(id, scope, elements);
        return elements;
    }
    const std::uint32_t number = r_.of_expression[id];
    if (number != kNone && number >= constants_.size()) {
        constants_.resize(r_.constants, Value::unset());  // Lists inside this one have numbers too: it lies still now.
    }
    Value* const constant = number == kNone ? nullptr : &constants_[number];
    if (constant != nullptr && !constant->is_unset()) {
        return *constant;
    }
    const auto parts = p_.elements_of(e);
    constexpr std::size_t kFew = 4;
    if (parts.size() <= kFew &&
        std::none_of(parts.begin(), parts.end(), [&](ExprId part) { return is_element_kind(p_[part].kind); })) {
        std::array<Value, kFew> few;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            few[i] = evaluate(parts[i], scope);
        }
        Value value = Value::list(std::span(few).first(parts.size()));
        if (constant != nullptr) {
            *constant = value;
        }
        return value;
    }
    std::vector<Value> elements;
    elements.reserve(parts.size());
    for (const ExprId part : parts) {
        collect(part, scope, elements);
    }
    Value value(std::move(elements));
    if (constant != nullptr) {
        *constant = value;
    }
    return value;
}

Value Evaluator::evaluate_unary(const Expr& e, Scope& scope) {
    Value temporary;
    const Value& a = operand(e.operand(0), scope, temporary);
    if (a.is_number() && e.op == Operator::Negate) {
        return -a.number();
    }
    std::string problem;
    Value result = apply_unary(e.op, a, problem);
    if (!problem.empty()) {
        warn(e.where, std::move(problem));
    }
    return result;
}

bool Evaluator::is_true(ExprId id, Scope& scope) {
    Value temporary;
    const Value& value = operand(id, scope, temporary);
    return value.is_bool() ? value.boolean() : static_cast<bool>(value);
}

/// `v.x`, `v.zy`, `v.rgb`, …: up to four of one set of letters; undef else, and where an element is missing.
static Value swizzle(const Value& vector, std::string_view letters) {
    constexpr std::size_t kMost = 4;
    for (const std::string_view set : {"xyzw", "rgba"}) {
        if (letters.empty() || letters.size() > kMost || letters.find_first_not_of(set) != std::string_view::npos) {
            continue;
        }
        if (letters.size() == 1) {
            return element_of(vector, static_cast<double>(set.find(letters[0])));
        }
        std::vector<Value> result;
        for (const char letter : letters) {
            const std::size_t index = set.find(letter);
            if (index >= vector.elements().size()) {
                return {};
            }
            result.push_back(vector.elements()[index]);
        }
        return result;
    }
    return {};
}

static Value member_of(const Value& value, std::string_view member) {
    if (value.is_vector()) {
        return swizzle(value, member);
    }
    if (value.is_range()) {
        const Range& r = value.range();
        return member == "begin"  ? Value(r.begin)
               : member == "step" ? Value(r.step)
               : member == "end"  ? Value(r.end)
                                  : Value();
    }
    return value.is_object() ? member_of_object(value, member) : Value();
}

static bool is_link(ExprKind kind) {
    return kind == ExprKind::Binary || kind == ExprKind::Index || kind == ExprKind::Member;
}

/// Chains (`a + b + c`, `a[0][1].x`) grow to the left without brackets. A long one is worked out in a loop.
Value Evaluator::evaluate_chain(const Expr& e, Scope& scope) {
    constexpr std::uint8_t kLong = 64;
    if (e.links < kLong) {
        Value temporary;
        return apply(e, operand(e.operand(0), scope, temporary), scope);
    }
    std::vector<const Expr*> chain;
    for (const Expr* x = &e; is_link(x->kind); x = &p_[x->operand(0)]) {
        chain.push_back(x);
    }
    Value value = evaluate(chain.back()->operand(0), scope);
    for (auto link = chain.rbegin(); link != chain.rend(); ++link) {
        value = apply(**link, value, scope);
    }
    return value;
}

/// The value of a link of a chain whose left operand is `a`.
Value Evaluator::apply(const Expr& e, const Value& a, Scope& scope) {
    Value temporary;
    if (e.kind == ExprKind::Index) {
        const Value& index = operand(e.operand(1), scope, temporary);
        if (a.is_vector() && index.is_number() && index.number() >= 0) {
            const auto elements = a.elements();
            const double i = index.number();
            return i < static_cast<double>(elements.size()) ? elements[static_cast<std::size_t>(i)] : Value();
        }
        return element_of(a, index);
    }
    if (e.kind == ExprKind::Member) {
        return member_of(a, name(e.name));
    }
    if (e.op == Operator::And) {
        return a && is_true(e.operand(1), scope);
    }
    if (e.op == Operator::Or) {
        return a || is_true(e.operand(1), scope);
    }
    const Value& b = operand(e.operand(1), scope, temporary);
    if (a.is_number() && b.is_number()) {  // What most programs spend their time on.
        const double x = a.number(), y = b.number();
        switch (e.op) {
            case Operator::Add:
                return x + y;
            case Operator::Subtract:
                return x - y;
            case Operator::Multiply:
                return x * y;
            case Operator::Divide:
                return x / y;
            case Operator::Modulo:
                return remainder_of(x, y);
            case Operator::Less:
                return x < y;
            case Operator::LessEqual:
                return x <= y;
            case Operator::Greater:
                return x > y;
            case Operator::GreaterEqual:
                return x >= y;
            case Operator::Equal:
                return x == y;
            case Operator::NotEqual:
                return x != y;
            default:
                break;
        }
    }
    return apply_any(e, a, b);
}

/// Apart from `apply`, whose frame stays small.
Value Evaluator::apply_any(const Expr& e, const Value& a, const Value& b) {
    std::string problem;
    Value result = apply_binary(e.op, a, b, problem);
    if (!problem.empty()) {
        warn(e.where, std::move(problem));
    }
    return result;
}

Value Evaluator::evaluate_range(const Expr& e, Scope& scope) {
    const Value begin = evaluate(e.operand(0), scope);
    const Value step = e.operand(1) == kNone ? Value(1.0) : evaluate(e.operand(1), scope);
    const Value end = evaluate(e.operand(2), scope);
    if (!begin.is_number() || !end.is_number()) {
        warn(e.where, fmt::format("Unable to convert [{}:...:{}] to a range", begin.echo_text(), end.echo_text()));
        return {};
    }
    if (!step.is_number()) {
        warn(e.where, fmt::format("Unable to convert [...:{}:...] to a step value", step.echo_text()));
        return {};
    }
    const Range range{begin.number(), step.number(), end.number()};
    if (!std::isfinite(range.begin) || !std::isfinite(range.step) || !std::isfinite(range.end)) {
        return range;  // Whoever goes through it will say so.
    }
    const bool backwards = range.step < 0;
    if (backwards ? range.end > range.begin : range.step > 0 && range.end < range.begin) {
        // Only where all three are written as literals: a loop that may go round no time is no mistake.
        const auto written = [&](std::size_t i) { return e.operand(i) == kNone || is_literal(p_, e.operand(i)); };
        if (written(0) && written(1) && written(2)) {
            warn(e.where, backwards ? "begin is smaller than the end, but step is negative"
                                    : "begin is greater than the end, but step is positive");
        }
    }
    return range;
}

Value Evaluator::make_closure(ExprId id, Scope& scope) {
    const LiteralInfo& info = r_.literals[r_.of_expression[id]];
    auto* closure = new Closure(p_, id, scope.frame, info.this_parameter != kNone);
    Value value(closure);
    closure->captures.reserve(info.captures.size());
    for (const CaptureSource& source : info.captures) {
        if (source.late) {
            closure->captures.emplace_back();
            late_.push_back({value, closure->captures.size() - 1, &scope.locals[source.slot]});
            continue;
        }
        closure->captures.push_back(source.from_capture ? variable({Place::Capture, 0, source.slot, kNone}, scope)
                                                        : scope.locals[source.slot]);
    }
    return value;
}

void Evaluator::bind_local(const Argument& a, Value value, Scope& scope) {
    const auto index = index_of(a);
    const std::uint32_t slot = r_.argument_slots[index];
    if (dynamic_name(a.name)) {
        bind_dynamic(slot, std::move(value));
    } else {
        scope.locals[slot] = std::move(value);
    }
}

bool Evaluator::is_repeated(std::span<const Argument> arguments, const Argument& a) {
    return std::any_of(arguments.data(), &a, [&](const Argument& before) { return before.name == a.name; });
}

void Evaluator::bind_let(std::span<const Argument> arguments, Scope& scope) {
    const std::size_t late = late_.size();
    for (const Argument& a : arguments) {
        Value value = evaluate(a.value, scope);
        if (a.name == kNoSymbol) {
            warn(a.where, fmt::format("Assignment without variable name {}", value.echo_text()));
            continue;
        }
        if (is_repeated(arguments, a)) {
            warn(a.where,
                 fmt::format("Ignoring duplicate variable assignment \"{}\" = {}", name(a.name), value.echo_text()));
            continue;
        }
        bind_local(a, std::move(value), scope);
        if (late_.size() != late && !dynamic_name(a.name)) {
            settle(late, &scope.locals[r_.argument_slots[index_of(a)]]);
        }
    }
}

/// Closures that were ahead of the variable in `slot` get it; those of a surrounding let go on waiting.
void Evaluator::settle(std::size_t first, const Value* slot) {
    std::size_t kept = first;
    for (std::size_t i = first; i < late_.size(); ++i) {
        Late& l = late_[i];
        if (l.slot != slot) {
            std::swap(late_[kept++], l);
            continue;
        }
        auto& closure = static_cast<Closure&>(l.closure.function());
        if (slot->is_function() && &slot->function() == &closure) {
            closure.captures[l.capture] = Value::unset();  // Itself: no circle of references.
        } else {
            closure.captures[l.capture] = *slot;
            knotted_.push_back(l.closure);
        }
    }
    late_.resize(kept);
}

std::string Closure::text() const {
    return expression_text(program, literal);
}

void Closure::take_captures(std::vector<Value>& out) {
    for (Value& value : captures) {
        out.push_back(std::move(value));
    }
    captures.clear();
}

void Evaluator::echo(std::span<const Argument> arguments, Scope& scope) {
    std::string text;
    for (const Argument& a : arguments) {
        text += text.empty() ? "" : ", ";
        if (a.name != kNoSymbol) {
            text += name(a.name) + " = ";
        }
        text += evaluate(a.value, scope).echo_text();
    }
    emit(Severity::Echo, {}, std::move(text));
}

void Evaluator::check_assertion(std::span<const Argument> arguments, const SourceRange& where, Scope& scope) {
    const Argument* condition = nullptr;
    const Argument* message = nullptr;
    for (const Argument& a : arguments) {
        const bool named = a.name != kNoSymbol;
        const Argument*& target =
            named ? (name(a.name) == "message" ? message : condition) : (condition == nullptr ? condition : message);
        target = &a;
    }
    if (condition != nullptr && evaluate(condition->value, scope)) {
        return;
    }
    std::string text = "Assertion";
    if (condition != nullptr) {
        text += fmt::format(" '{}'", expression_text(p_, condition->value));
    }
    text += " failed";
    if (message != nullptr) {
        text += ": " + evaluate(message->value, scope).echo_text();
    }
    fail(where, std::move(text));
}

}  // namespace csg::scad
