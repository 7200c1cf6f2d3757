// What instructions do where it takes more than a few steps: variables, operators, members, closures.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "csg/scad/customizer/annotations.h"
#include "csg/scad/machine/machine.h"
#include "csg/scad/machine/operators.h"
#include "csg/scad/text/expression_text.h"
#include "csg/scad/value/object.h"

namespace csg::scad {

/// `a`: null where there are no locals.
Value Evaluator::variable(const VariableRef& ref, const Frame* frame, const Activation* a) {
    switch (ref.place) {
        case Place::Children:
            return frame == nullptr || frame->module == nullptr
                       ? Value::unset()
                       : Value(static_cast<double>(child_count(*frame->module)));
        case Place::Pi:
            return std::numbers::pi;
        case Place::Local:
            return a->registers[ref.slot];
        case Place::Capture: {
            const Value& value = a->closure().captures[ref.slot];
            return value.is_unset() ? a->function : value;
        }
        case Place::Dynamic:
            note_read(ref.slot);
            return dynamic_[ref.slot];
        case Place::Block: {
            const Value& value = outward(frame, ref.hops)->slots[ref.slot];
            return value.is_unset() && ref.next != kNone ? variable(r_.variables[ref.next], frame, a) : value;
        }
        case Place::Unknown:
            break;
    }
    return Value::unset();
}

Value Evaluator::variable_or_warn(const Instruction& i, const Activation& a) {
    Value value = variable(r_.variables[i.a], a.frame, &a);
    return value.is_unset() ? unknown_variable(i.e) : value;
}

Value Evaluator::unknown_variable(ExprId id) {
    warn(p_[id].where, fmt::format("Ignoring unknown variable \"{}\"", name(p_[id].name)));
    return {};
}

const Value& Evaluator::text_constant(Symbol text) {
    if (text >= strings_.size()) {
        strings_.resize(p_.symbols.size(), Value::unset());  // Room is kept: what is there stays where it is.
    }
    Value& value = strings_[text];
    if (value.is_unset()) {
        value = Value::lasting(name(text));
    }
    return value;
}

Value Evaluator::apply_binary(const Instruction& i, const Value& a, const Value& b) {
    std::string problem;
    Value result = scad::apply_binary(p_[i.e].op, a, b, problem);
    if (!problem.empty()) {
        warn(p_[i.e].where, std::move(problem));
    }
    return result;
}

bool Evaluator::compare(const Instruction& i, const Value& a, const Value& b) {
    return static_cast<bool>(apply_binary(i, a, b));
}

Value Evaluator::apply_unary(const Instruction& i, const Value& a) {
    std::string problem;
    Value result = scad::apply_unary(p_[i.e].op, a, problem);
    if (!problem.empty()) {
        warn(p_[i.e].where, std::move(problem));
    }
    return result;
}

/// `v.x`, `v.zy`, `v.rgb`, …: up to four of one set of letters; undef else. Missing elements are undef.
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
            result.push_back(element_of(vector, static_cast<double>(set.find(letter))));
        }
        return result;
    }
    return {};
}

Value Evaluator::member_of(const Value& value, std::string_view member) {
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

/// Whether `parts` (begin, step, end) are numbers; warns of what makes no sense.
bool Evaluator::check_range(ExprId id, const Value* parts) {
    const Expr& e = p_[id];
    const Value &begin = parts[0], &step = parts[1], &end = parts[2];
    if (!begin.is_number() || !end.is_number()) {
        warn(e.where, fmt::format("Unable to convert [{}:...:{}] to a range", begin.echo_text(), end.echo_text()));
        return false;
    }
    if (!step.is_number()) {
        warn(e.where, fmt::format("Unable to convert [...:{}:...] to a step value", step.echo_text()));
        return false;
    }
    const Range range{begin.number(), step.number(), end.number()};
    if (!std::isfinite(range.begin) || !std::isfinite(range.step) || !std::isfinite(range.end)) {
        return true;  // Whoever goes through it will say so.
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
    return true;
}

Value Evaluator::make_closure(ExprId id, Activation& a) {
    const LiteralInfo& info = r_.literals[r_.of_expression[id]];
    auto* closure = new Closure(p_, id, a.frame, info.this_parameter != kNone);
    Value value(closure);
    closure->captures.reserve(info.captures.size());
    for (const CaptureSource& source : info.captures) {
        if (source.late) {
            closure->captures.emplace_back();
            late_.push_back({value, closure->captures.size() - 1, a.registers + source.slot});
            continue;
        }
        closure->captures.push_back(source.from_capture ? variable({Place::Capture, 0, source.slot, kNone}, a.frame, &a)
                                                        : a.registers[source.slot]);
    }
    return value;
}

/// Closures that were ahead of the variable in `slot` get it.
void Evaluator::settle(const Value* slot) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < late_.size(); ++i) {
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

void Evaluator::warn_assignment(const Instruction& i, const Value& value) {
    const Argument& a = p_.arguments[i.b];
    warn(a.where, a.name == kNoSymbol ? fmt::format("Assignment without variable name {}", value.echo_text())
                                      : fmt::format("Ignoring duplicate variable assignment \"{}\" = {}", name(a.name),
                                                    value.echo_text()));
}

void Evaluator::echo(std::span<const Argument> arguments, const Value* values) {
    std::string text;
    for (const Argument& a : arguments) {
        text += text.empty() ? "" : ", ";
        if (a.name != kNoSymbol) {
            text += name(a.name) + " = ";
        }
        text += (values++)->echo_text();
    }
    emit(Severity::Echo, {}, std::move(text));
}

void Evaluator::fail_assertion(const SourceRange& where, ExprId condition, const Value* message) {
    std::string text = "Assertion";
    if (condition != kNone) {
        text += fmt::format(" '{}'", expression_text(p_, condition));
    }
    text += " failed";
    if (message != nullptr) {
        text += ": " + message->echo_text();
    }
    fail(where, std::move(text));
}

}  // namespace csg::scad
