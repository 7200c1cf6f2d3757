#include "csg/scad/customizer/customizer.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "csg/scad/customizer/annotations.h"
#include "csg/scad/value/quoted.h"
#include "csg/scad/value/value.h"

namespace csg::scad {

namespace {

using Kind = CommentValue::Kind;
constexpr std::size_t kMostNumbers = 4;  // Of a list.

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

std::optional<double> number_in(std::string_view text) {
    text = trimmed(text);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() && std::isfinite(number) ? std::optional(number)
                                                                                             : std::nullopt;
}

/// "[1, 2]".
std::optional<std::vector<double>> numbers_in(std::string_view text) {
    text = trimmed(text);
    if (text.size() < 2 || text.front() != '[' || text.back() != ']') {
        return std::nullopt;
    }
    text = text.substr(1, text.size() - 2);
    std::vector<double> numbers;
    for (;;) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const auto number = number_in(text.substr(0, comma));
        if (!number || numbers.size() == kMostNumbers) {
            return std::nullopt;
        }
        numbers.push_back(*number);
        if (comma == text.size()) {
            return numbers;
        }
        text.remove_prefix(comma + 1);
    }
}

std::optional<double> number_of(const Program& program, ExprId id) {
    const Expr& e = program[id];
    if (e.kind == ExprKind::Number) {
        return e.number;
    }
    const bool negative = e.kind == ExprKind::Unary && e.op == Operator::Negate;
    return negative && program[e.operand(0)].kind == ExprKind::Number ? std::optional(-program[e.operand(0)].number)
                                                                      : std::nullopt;
}

std::optional<CustomizerParameter::Value> initial_of(const Program& program, ExprId id) {
    const Expr& e = program[id];
    if (e.kind == ExprKind::Boolean) {
        return e.number != 0;
    }
    if (e.kind == ExprKind::String) {
        return program.symbols.text(e.name);
    }
    if (const auto number = number_of(program, id)) {
        return *number;
    }
    if (e.kind != ExprKind::Vector || e.list.count == 0 || e.list.count > kMostNumbers) {
        return std::nullopt;
    }
    std::vector<double> numbers;
    for (const ExprId element : program.elements_of(e)) {
        const auto number = number_of(program, element);
        if (!number) {
            return std::nullopt;
        }
        numbers.push_back(*number);
    }
    return numbers;
}

CustomizerParameter::Option option_of(const CommentValue& item) {
    const bool labeled = item.kind == Kind::List && item.items.size() == 2;
    const CommentValue& value = labeled ? item.items[0] : item;
    const auto text_of = [](const CommentValue& v) { return v.kind == Kind::Number ? number_text(v.number) : v.text; };
    CustomizerParameter::Option option{text_of(labeled ? item.items[1] : item), value.text};
    if (value.kind == Kind::Number) {
        option.value = value.number;
    }
    return option;
}

/// The range is made wide enough for what the file says, as in OpenSCAD.
void widen_range(CustomizerParameter& p) {
    const auto take = [&p](double number) {
        p.minimum = p.minimum ? std::min(*p.minimum, number) : p.minimum;
        p.maximum = p.maximum ? std::max(*p.maximum, number) : p.maximum;
    };
    if (const auto* const numbers = std::get_if<std::vector<double>>(&p.initial)) {
        std::for_each(numbers->begin(), numbers->end(), take);
    } else if (const auto* const number = std::get_if<double>(&p.initial)) {
        take(*number);
    }
}

/// Before the others, where it is none of them, as in OpenSCAD.
void add_initial_option(CustomizerParameter& p) {
    CustomizerParameter::Option own;
    if (const auto* const number = std::get_if<double>(&p.initial)) {
        own = {number_text(*number), *number};
    } else {
        const auto& text = std::get<std::string>(p.initial);
        own = {text, text};
    }
    if (std::none_of(p.options.begin(), p.options.end(), [&](const auto& o) { return o.value == own.value; })) {
        p.options.insert(p.options.begin(), std::move(own));
    }
}

/// What the comment behind a number, or a list of numbers, says about the least, the most and the step.
bool take_range(CustomizerParameter& p, const CommentValue& form) {
    if (form.kind == Kind::Range) {
        p.minimum = form.items.front().number;
        p.maximum = form.items.back().number;
        p.step = form.items.size() == 3 ? form.items[1].number : 1;
        return true;
    }
    if (form.kind == Kind::List && form.items.size() == 1 && form.items[0].kind == Kind::Number) {
        p.minimum = 0;
        p.maximum = form.items[0].number;
        p.step = 1;
        return true;
    }
    if (form.kind == Kind::Number) {
        p.step = form.number;
        return true;
    }
    return false;
}

void take_form(CustomizerParameter& p, const CommentValue& form) {
    const bool number = std::holds_alternative<double>(p.initial);
    if (number || std::holds_alternative<std::vector<double>>(p.initial)) {
        if (take_range(p, form)) {
            widen_range(p);
            return;
        }
        p.step = number && form.kind != Kind::List ? std::optional(1.0) : std::nullopt;
    }
    const bool text = std::holds_alternative<std::string>(p.initial);
    if (form.kind == Kind::List && (number || text)) {
        std::transform(form.items.begin(), form.items.end(), std::back_inserter(p.options), option_of);
        add_initial_option(p);
    } else if (text && form.kind == Kind::Number && form.number >= 0 && form.number < 1e9) {
        p.longest = static_cast<std::size_t>(form.number);
    }
}

double clamped(const CustomizerParameter& p, double number) {
    number = p.maximum ? std::min(number, *p.maximum) : number;
    return p.minimum ? std::max(number, *p.minimum) : number;
}

}  // namespace

std::vector<CustomizerParameter> customizer_parameters(const Program& program) {
    std::vector<CustomizerParameter> result;
    const BlockId block = program.units[0].block;
    if (block == kNone) {
        return result;
    }
    const auto assignments = program.assignments_of(program.blocks[block]);
    const auto comments = annotations(program);
    for (std::size_t i = 0; i < assignments.size(); ++i) {
        if (!comments[i]) {
            continue;
        }
        const std::string group(trimmed(comments[i]->group.value_or("Parameters")));
        if (group == "Hidden") {
            continue;
        }
        if (auto initial = initial_of(program, assignments[i].value)) {
            CustomizerParameter& p = result.emplace_back();
            p.name = program.symbols.text(assignments[i].name);
            p.caption = comments[i]->description;
            p.group = group;
            p.initial = std::move(*initial);
            take_form(p, comments[i]->form);
        }
    }
    return result;
}

std::optional<CustomizerParameter::Value> fitted_value(const CustomizerParameter& p, std::string_view text) {
    if (!p.options.empty()) {
        const auto number = number_in(text);
        for (const auto& option : p.options) {
            const auto* const value = std::get_if<double>(&option.value);
            if (value != nullptr ? number == *value : std::get<std::string>(option.value) == text) {
                return std::visit([](const auto& v) { return CustomizerParameter::Value(v); }, option.value);
            }
        }
        return std::nullopt;
    }
    if (std::holds_alternative<bool>(p.initial)) {
        return text == "true" || text == "false" ? std::optional<CustomizerParameter::Value>(text == "true")
                                                 : std::nullopt;
    }
    if (std::holds_alternative<std::string>(p.initial)) {
        return std::string(text);
    }
    if (std::holds_alternative<double>(p.initial)) {
        const auto number = number_in(text);
        return number ? std::optional<CustomizerParameter::Value>(clamped(p, *number)) : std::nullopt;
    }
    auto numbers = numbers_in(text);
    if (!numbers || numbers->size() != std::get<std::vector<double>>(p.initial).size()) {
        return std::nullopt;
    }
    for (double& number : *numbers) {
        number = clamped(p, number);
    }
    return *numbers;
}

std::string expression_of(const CustomizerParameter::Value& value) {
    const auto* const text = std::get_if<std::string>(&value);
    return text != nullptr ? quoted(*text) : set_text(value);
}

std::string set_text(const CustomizerParameter::Value& value) {
    if (const auto* const truth = std::get_if<bool>(&value)) {
        return *truth ? "true" : "false";
    }
    if (const auto* const number = std::get_if<double>(&value)) {
        return fmt::format("{}", *number);
    }
    if (const auto* const numbers = std::get_if<std::vector<double>>(&value)) {
        return fmt::format("[{}]", fmt::join(*numbers, ", "));
    }
    return std::get<std::string>(value);
}

}  // namespace csg::scad
