#include "csg/scad/operators.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "csg/scad/object.h"

namespace csg::scad {

namespace {

Value undefined(Operator op, const Value& a, const Value& b, std::string& problem) {
    problem =
        fmt::format("undefined operation ({} {} {})", type_name(a.type()), operator_text(op), type_name(b.type()));
    return {};
}

bool all_numbers(std::span<const Value> v) {
    return std::all_of(v.begin(), v.end(), [](const Value& e) { return e.is_number(); });
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
                if (o != 0) {
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

/// Lists up to here are made without a vector: points, mostly.
constexpr std::size_t kFew = 4;

/// `f` of each element; nested lists element by element.
template <typename F>
Value map(std::span<const Value> elements, F&& f) {
    if (elements.size() <= kFew) {
        std::array<Value, kFew> few;
        for (std::size_t i = 0; i < elements.size(); ++i) {
            few[i] = f(elements[i]);
        }
        return Value::list(std::span(few).first(elements.size()));
    }
    std::vector<Value> result;
    result.reserve(elements.size());
    for (const Value& e : elements) {
        result.push_back(f(e));
    }
    return result;
}

Value dot(std::span<const Value> a, std::span<const Value> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!a[i].is_number() || !b[i].is_number()) {
            return {};
        }
        sum += a[i].number() * b[i].number();
    }
    return sum;
}

/// A row vector times a matrix, which has `v.size()` rows.
Value times_matrix(std::span<const Value> v, std::span<const Value> matrix, std::string& problem) {
    const std::size_t columns = matrix[0].is_vector() ? matrix[0].elements().size() : 0;
    std::vector<Value> result(columns, Value(0.0));
    for (std::size_t row = 0; row < matrix.size(); ++row) {
        if (!matrix[row].is_vector() || matrix[row].elements().size() != columns) {
            problem = "Matrix must be rectangular";
            return {};
        }
        for (std::size_t column = 0; column < columns; ++column) {
            const Value& m = matrix[row].elements()[column];
            if (!v[row].is_number() || !m.is_number()) {
                problem = fmt::format("Matrix must contain only numbers. Problem at row {}, col {}", row, column);
                return {};
            }
            result[column] = result[column].number() + v[row].number() * m.number();
        }
    }
    return result;
}

Value multiply_vectors(const Value& a, const Value& b, std::string& problem) {
    const auto x = a.elements(), y = b.elements();
    if (x.empty() || y.empty()) {
        problem = "Multiplication is undefined on empty vectors";
        return {};
    }
    const auto mismatch = [&problem](std::string_view text, std::size_t m, std::size_t n) {
        problem = fmt::format("{} ({} != {})", text, m, n);
        return Value();
    };
    const auto is_matrix = [](std::span<const Value> v) { return v[0].is_vector(); };
    if (!is_matrix(x) && !is_matrix(y)) {
        if (x.size() != y.size()) {
            return mismatch("vector*vector requires matching lengths", x.size(), y.size());
        }
        return all_numbers(x) && all_numbers(y) ? dot(x, y) : undefined(Operator::Multiply, a, b, problem);
    }
    if (!is_matrix(x)) {
        return x.size() == y.size()
                   ? times_matrix(x, y, problem)
                   : mismatch("vector*matrix requires vector length to match matrix row count", x.size(), y.size());
    }
    const std::size_t columns = x[0].elements().size();
    if (columns != y.size()) {
        return is_matrix(y)
                   ? mismatch("matrix*matrix requires left operand column count to match right operand row count",
                              columns, y.size())
                   : mismatch("matrix*vector requires matrix column count to match vector length", columns, y.size());
    }
    std::vector<Value> result;
    for (const Value& row : x) {
        const std::size_t length = row.is_vector() ? row.elements().size() : 0;
        if (!row.is_vector() || length != columns) {
            problem = is_matrix(y) ? fmt::format(
                                         "matrix*matrix left operand row length does not match right operand "
                                         "row count ({} != {}) at row {}",
                                         length, y.size(), result.size())
                                   : "Matrix must be rectangular";
            return {};
        }
        result.push_back(is_matrix(y) ? times_matrix(row.elements(), y, problem) : dot(row.elements(), y));
        if (result.back().is_undef()) {
            if (problem.empty()) {
                problem = "Matrix must contain only numbers";
            }
            return {};
        }
    }
    return result;
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

Value arithmetic(Operator op, const Value& a, const Value& b, std::string& problem, int depth = 0) {
    if (a.is_number() && b.is_number()) {
        const double x = a.number(), y = b.number();
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
    if (depth > kMaxListDepth) {
        return undefined(op, a, b, problem);
    }
    const bool scaling = op == Operator::Multiply || op == Operator::Divide;
    if (a.is_vector() && b.is_vector()) {
        if (op == Operator::Multiply) {
            return multiply_vectors(a, b, problem);
        }
        if (op == Operator::Add || op == Operator::Subtract) {
            const auto x = a.elements(), y = b.elements();
            return map(x.first(std::min(x.size(), y.size())), [&](const Value& e) {
                return arithmetic(op, e, y[static_cast<std::size_t>(&e - x.data())], problem, depth + 1);
            });
        }
    } else if (scaling && a.is_vector() && b.is_number()) {
        return map(a.elements(), [&](const Value& e) { return arithmetic(op, e, b, problem, depth + 1); });
    } else if (scaling && a.is_number() && b.is_vector()) {
        return map(b.elements(), [&](const Value& e) { return arithmetic(op, a, e, problem, depth + 1); });
    }
    return undefined(op, a, b, problem);
}

Value negate(const Value& a, std::string& problem, int depth) {
    if (a.is_number()) {
        return -a.number();
    }
    if (a.is_vector() && depth <= kMaxListDepth) {
        return map(a.elements(), [&](const Value& e) { return negate(e, problem, depth + 1); });
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
    if (!index.is_number() || !(index.number() >= 0) || index.number() > 4294967295.0) {
        return {};
    }
    const auto i = static_cast<std::size_t>(index.number());
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
