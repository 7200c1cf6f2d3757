#include "csg/scad/machine/operators.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "csg/scad/value/object.h"
#include "csg/scad/value/vector_product.h"

namespace csg::scad {

namespace {

Value undefined(Operator op, const Value& a, const Value& b, std::string& problem) {
    problem =
        fmt::format("undefined operation ({} {} {})", type_name(a.type()), operator_text(op), type_name(b.type()));
    return {};
}

/// Less, equal or greater as -1, 0, 1; 2 for unordered numbers; nothing where the types do not compare. `steps` counts
/// the elements that were looked at.
std::optional<int> order(const Value& a, const Value& b, std::size_t& steps, int depth = 0) {
    constexpr int kMaxDepth = 1000;  // Deeper lists do not compare.
    constexpr auto three_way = [](const auto& x, const auto& y) { return x < y ? -1 : x > y ? 1 : x == y ? 0 : 2; };
    constexpr std::size_t kMostSteps = 50'000'000;
    if (a.type() != b.type() || depth > kMaxDepth) {
        return std::nullopt;
    }
    if (++steps > kMostSteps) {
        throw ValueLimit("The lists are too large to compare");
    }
    note_values(1);
    switch (a.type()) {
        case ValueType::Bool:
            return three_way(a.boolean(), b.boolean());
        case ValueType::Number:
            return three_way(a.number(), b.number());
        case ValueType::String:
            return three_way(a.string().compare(b.string()), 0);
        case ValueType::Range: {
            const Range &r = a.range(), &s = b.range();
            const std::uint32_t m = r.count(), n = s.count();
            if (m == 0 || n == 0 || r.begin != s.begin) {
                return m == 0 || n == 0 ? three_way(m, n) : three_way(r.begin, s.begin);
            }
            return m > 1 && n > 1 && r.step != s.step ? three_way(r.step, s.step) : three_way(m, n);
        }
        case ValueType::Vector: {
            const auto x = a.elements(), y = b.elements();
            for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
                const auto o = order(x[i], y[i], steps, depth + 1);
                // What is equal does not decide, nor does what is no number: the elements after it do.
                const bool decides = !o.has_value() || *o == -1 || *o == 1;
                if (decides) {
                    return o;
                }
            }
            return three_way(x.size(), y.size());
        }
        default:
            return std::nullopt;
    }
}

Value compare(Operator op, const Value& a, const Value& b, std::string& problem) {
    std::size_t steps = 0;
    const auto o = order(a, b, steps);
    if (!o && a.type() == b.type() && !a.is_vector()) {
        problem =
            fmt::format("operation undefined ({} {} {})", type_name(a.type()), operator_text(op), type_name(b.type()));
        return {};
    }
    if (!o) {
        return undefined(op, a, b, problem);
    }
    switch (op) {
        case Operator::Less:
            return *o == -1;
        case Operator::LessEqual:
            return *o == -1 || *o == 0;
        case Operator::Greater:
            return *o == 1;
        default:
            return *o == 1 || *o == 0;
    }
}

/// `f` of each element; nested lists element by element.
template <typename F>
Value map(std::span<const Value> elements, F&& f) {
    return Value::list_of(elements.size(), [&](std::size_t i) { return f(elements[i]); });
}

/// Into the 64 bits of an integer, those above 2^63 included.
std::int64_t to_bits(double number) {
    if (!(std::abs(number) < 18446744073709551616.0)) {
        return 0;
    }
    if (number >= 9223372036854775808.0) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(number));
    }
    return number < -9223372036854775808.0 ? 0 : static_cast<std::int64_t>(number);
}

Value bits(Operator op, const Value& a, const Value& b, std::string& problem) {
    if (!a.is_number() || !b.is_number()) {
        return undefined(op, a, b, problem);
    }
    const std::int64_t x = to_bits(a.number()), y = to_bits(b.number());
    if (op == Operator::BitAnd || op == Operator::BitOr) {
        return static_cast<double>(op == Operator::BitAnd ? x & y : x | y);
    }
    if (y < 0 || y >= 64) {
        problem = y < 0 ? "negative shift" : "shift too large";
        return {};
    }
    const auto shifted =
        op == Operator::ShiftLeft ? static_cast<std::int64_t>(static_cast<std::uint64_t>(x) << y) : x >> y;
    return static_cast<double>(shifted);
}

constexpr int kMaxListDepth = 1000;

double of_numbers(Operator op, double x, double y) {
    switch (op) {
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
        default:
            return std::pow(x, y);
    }
}

Value arithmetic(Operator op, const Value& a, const Value& b, std::string& problem, int depth = 0);

/// A list of `count` elements, each of the operands that `left` and `right` give for it; undef, without a word, where
/// they do not fit.
template <typename Left, typename Right>
Value each(Operator op, std::size_t count, Left&& left, Right&& right, int depth) {
    std::string problem;
    const auto made = [&](auto&& f) {
        return Value::list_of(count, [&](std::size_t i) {
            const Value &x = left(i), &y = right(i);
            return x.is_number() && y.is_number() ? Value(f(x.number(), y.number()))
                                                  : arithmetic(op, x, y, problem, depth + 1);
        });
    };
    switch (op) {
        case Operator::Add:
            return made([](double x, double y) { return x + y; });
        case Operator::Subtract:
            return made([](double x, double y) { return x - y; });
        case Operator::Multiply:
            return made([](double x, double y) { return x * y; });
        default:
            return made([](double x, double y) { return x / y; });
    }
}

Value arithmetic(Operator op, const Value& a, const Value& b, std::string& problem, int depth) {
    if (a.is_number() && b.is_number()) {
        return of_numbers(op, a.number(), b.number());
    }
    if (depth > kMaxListDepth) {
        return undefined(op, a, b, problem);
    }
    const bool scaling = op == Operator::Multiply || op == Operator::Divide;
    const auto element_of = [](const Value& list) {
        return [elements = list.elements()](std::size_t i) -> const Value& { return elements[i]; };
    };
    const auto same = [](const Value& value) { return [&value](std::size_t) -> const Value& { return value; }; };
    if (a.is_vector() && b.is_vector()) {
        if (op == Operator::Multiply) {
            return multiply_vectors(a, b, problem);
        }
        if (op == Operator::Add || op == Operator::Subtract) {
            const std::size_t count = std::min(a.elements().size(), b.elements().size());
            return each(op, count, element_of(a), element_of(b), depth);
        }
    } else if (scaling && a.is_vector() && b.is_number()) {
        return each(op, a.elements().size(), element_of(a), same(b), depth);
    } else if (scaling && a.is_number() && b.is_vector()) {
        return each(op, b.elements().size(), same(a), element_of(b), depth);
    }
    return undefined(op, a, b, problem);
}

Value negate(const Value& a, std::string& problem, int depth) {
    if (a.is_number()) {
        return -a.number();
    }
    if (a.is_vector() && depth <= kMaxListDepth) {
        std::string ignored;
        return map(a.elements(), [&](const Value& e) { return negate(e, ignored, depth + 1); });
    }
    problem = fmt::format("undefined operation (-{})", type_name(a.type()));
    return {};
}

}  // namespace

double remainder_of(double x, double y) {
    constexpr double kWhole = 9007199254740992.0;  // 2^53
    if (x >= 0 && x < kWhole && y >= 1 && y < kWhole && !std::signbit(x)) {
        const auto i = static_cast<std::uint64_t>(x), j = static_cast<std::uint64_t>(y);
        if (static_cast<double>(i) == x && static_cast<double>(j) == y) {
            return static_cast<double>(i % j);
        }
    }
    return std::fmod(x, y);
}

Value apply_binary(Operator op, const Value& a, const Value& b, std::string& problem) {
    switch (op) {
        case Operator::Equal:
            return equal(a, b);
        case Operator::NotEqual:
            return !equal(a, b);
        case Operator::Less:
        case Operator::LessEqual:
        case Operator::Greater:
        case Operator::GreaterEqual:
            return compare(op, a, b, problem);
        case Operator::BitOr:
        case Operator::BitAnd:
        case Operator::ShiftLeft:
        case Operator::ShiftRight:
            return bits(op, a, b, problem);
        default:
            return arithmetic(op, a, b, problem);
    }
}

Value apply_unary(Operator op, const Value& a, std::string& problem) {
    switch (op) {
        case Operator::Not:
            return !static_cast<bool>(a);
        case Operator::Negate:
            return negate(a, problem, 0);
        case Operator::BitNot:
            if (a.is_number()) {
                return static_cast<double>(~to_bits(a.number()));
            }
            problem = fmt::format("undefined operation (~{})", type_name(a.type()));
            return {};
        default:
            return a;
    }
}

Value element_of(const Value& value, const Value& index) {
    if (value.is_object() && index.is_string()) {
        return member_of_object(value, index.string());
    }
    // Numbers are cut off to whole ones: above -1 means the first element.
    if (!index.is_number() || !(index.number() > -1) || index.number() > 4294967295.0) {
        return {};
    }
    const auto i = static_cast<std::size_t>(std::max(index.number(), 0.0));
    if (value.is_vector()) {
        return i < value.elements().size() ? value.elements()[i] : Value();
    }
    if (value.is_string()) {
        const std::string& text = value.string();
        if (i >= value.length()) {
            return {};
        }
        std::size_t at = i;
        if (value.length() != text.size()) {
            at = 0;
            for (std::size_t n = 0; n < i; ++n) {
                at += code_point_bytes(text, at);
            }
        }
        return text.substr(at, code_point_bytes(text, at));
    }
    if (value.is_range() && i < 3) {
        const Range& r = value.range();
        return i == 0 ? r.begin : i == 1 ? r.step : r.end;
    }
    return {};
}

}  // namespace csg::scad
