// Built-in functions of numbers, and the table's look-up.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "csg/scad/builtin/builtin_functions.h"
#include "csg/scad/builtin/sine.h"

namespace csg::scad {

bool check_count(std::string_view name, std::span<const Value> arguments, std::size_t at_least, std::size_t at_most,
                 std::string_view expected, FunctionHost& host) {
    if (arguments.size() >= at_least && arguments.size() <= at_most) {
        return true;
    }
    host.warn(fmt::format("{}() number of parameters does not match: expected {}, found {}", name, expected,
                          arguments.size()));
    return false;
}

bool check_type(std::string_view name, std::span<const Value> arguments, std::size_t index, ValueType expected,
                FunctionHost& host, std::string_view what) {
    const Value& value = arguments[index];
    if (value.type() == expected) {
        return true;
    }
    host.warn(fmt::format("{}() parameter could not be converted: {} {}: expected {}, found {} ({})", name, what, index,
                          type_name(expected), type_name(value.type()), value.echo_text()));
    return false;
}

namespace {

constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();

template <double (*F)(double)>
Value unary(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 1, 1, "1", host) || !check_type(name, a, 0, ValueType::Number, host)) {
        return {};
    }
    return F(a[0].number());
}

template <double (*F)(double, double)>
Value binary(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 2, 2, "2", host) || !check_type(name, a, 0, ValueType::Number, host) ||
        !check_type(name, a, 1, ValueType::Number, host)) {
        return {};
    }
    return F(a[0].number(), a[1].number());
}

double absolute(double x) {
    return std::abs(x);
}
double sign(double x) {
    return x < 0 ? -1 : x > 0 ? 1 : 0;
}
double floor_of(double x) {
    return std::floor(x);
}
double ceil_of(double x) {
    return std::ceil(x);
}
double round_of(double x) {
    return std::round(x);
}
double sqrt_of(double x) {
    return std::sqrt(x);
}
double exp_of(double x) {
    return std::exp(x);
}
double ln_of(double x) {
    return std::log(x);
}
double power(double x, double y) {
    return std::pow(x, y);
}

Value log(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 1, 2, "2", host) || !check_type(name, a, 0, ValueType::Number, host) ||
        (a.size() == 2 && !check_type(name, a, 1, ValueType::Number, host))) {
        return {};
    }
    // As OpenSCAD does: log(1000) is a little below 3.
    const double base = a.size() == 1 ? 10.0 : a[0].number();
    return std::log(a.back().number()) / std::log(base);
}

/// min() and max(): of the arguments, or of the elements of the one list given.
template <bool kMax>
Value extreme(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 1, kAny, "at least 1", host)) {
        return {};
    }
    std::string_view what = "argument";
    if (a.size() == 1 && a[0].is_vector()) {
        a = a[0].elements();
        what = "vector element";
        if (a.empty()) {
            host.warn(fmt::format(
                "{}() number of parameters does not match: expected at least 1 vector element, found 0", name));
            return {};
        }
    }
    double best = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!check_type(name, a, i, ValueType::Number, host, what)) {
            return {};
        }
        const double x = a[i].number();
        best = i == 0 || (kMax ? x > best : x < best) ? x : best;
    }
    return best;
}

Value norm(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 1, 1, "1", host) || !check_type(name, a, 0, ValueType::Vector, host)) {
        return {};
    }
    double sum = 0;
    for (const Value& e : a[0].elements()) {
        if (!e.is_number()) {
            host.warn("Incorrect arguments to norm()");
            return {};
        }
        sum += e.number() * e.number();
    }
    return std::sqrt(sum);
}

Value cross(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 2, 2, "2", host) || !check_type(name, a, 0, ValueType::Vector, host) ||
        !check_type(name, a, 1, ValueType::Vector, host)) {
        return {};
    }
    const auto v = a[0].elements(), w = a[1].elements();
    if (v.size() == 2 && w.size() == 2) {  // Taken as they are: what is no number counts as 0.
        const auto number = [](const Value& e) { return e.is_number() ? e.number() : 0.0; };
        return number(v[0]) * number(w[1]) - number(v[1]) * number(w[0]);
    }
    if (v.size() != 3 || w.size() != 3) {
        host.warn("Invalid vector size of parameter for cross()");
        return {};
    }
    std::array<double, 3> p{}, q{};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!v[i].is_number() || !w[i].is_number()) {
            host.warn("Invalid value in parameter vector for cross()");
            return {};
        }
        p[i] = v[i].number();
        q[i] = w[i].number();
        if (!std::isfinite(p[i]) || !std::isfinite(q[i])) {
            host.warn(fmt::format("Invalid value ({}) in parameter vector for cross()",
                                  std::isnan(p[i]) || std::isnan(q[i]) ? "NaN" : "INF"));
            return {};
        }
    }
    return std::vector<Value>{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// The seed of a generator: a number modulo 2^31 - 1, which is what OpenSCAD (with Python's hash of floating-point
/// numbers) takes; fractions count by the inverse of 2 there.
std::uint32_t seed_of(double number) {
    constexpr std::uint64_t kModulus = (std::uint64_t{1} << 31) - 1;
    constexpr int kBits = 31;  // 2^31 is 1 to this modulus: exponents count modulo 31.
    constexpr std::uint32_t kInfinity = 314159;
    if (std::isnan(number)) {
        return 0;
    }
    const auto with_sign = [&](std::uint32_t rest) { return std::signbit(number) ? ~rest + 1 : rest; };
    if (std::isinf(number)) {
        return with_sign(kInfinity);
    }
    int exponent = 0;
    const double fraction = std::frexp(std::abs(number), &exponent);
    const auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, std::numeric_limits<double>::digits));
    const int shift = ((exponent - std::numeric_limits<double>::digits) % kBits + kBits) % kBits;
    return with_sign(static_cast<std::uint32_t>((mantissa % kModulus << shift) % kModulus));
}

Value rands(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 3, 4, "3 or 4", host)) {
        return {};
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!check_type(name, a, i, ValueType::Number, host)) {
            return {};
        }
    }
    std::array<double, 2> bound{a[0].number(), a[1].number()};
    for (const auto& [i, word] : {std::pair<std::size_t, const char*>{0, "min"}, {1, "max"}}) {
        if (!std::isfinite(bound[i])) {
            host.warn(fmt::format("rands() range {} cannot be infinite", word));
            bound[i] = (i == 0 ? -1 : 1) * std::numeric_limits<double>::max() / 2;
            host.warn_without_place(fmt::format("resetting to {:f}", bound[i]));
        }
    }
    if (bound[1] < bound[0]) {
        std::swap(bound[0], bound[1]);
    }
    double count = std::abs(a[2].number());
    if (!std::isfinite(count)) {
        host.warn("rands() cannot create an infinite number of results");
        host.warn_without_place("resetting number of results to 1");
        count = 1;
    }
    if (count > static_cast<double>(host.max_elements)) {
        host.warn(fmt::format("rands() cannot create more than {} results", host.max_elements));
        return {};
    }
    ++host.effects;
    if (a.size() == 4) {
        host.random.seed(seed_of(a[3].number()));  // Calls without a seed go on from here.
    }
    std::uniform_real_distribution<double> distribution(bound[0], bound[1]);
    std::vector<Value> result(static_cast<std::size_t>(count));
    for (Value& value : result) {
        value = bound[0] == bound[1] ? bound[0] : distribution(host.random);
    }
    return result;
}

constexpr std::array kMath{
    FunctionEntry{"abs", unary<absolute>},
    FunctionEntry{"sign", unary<sign>},
    FunctionEntry{"sin", unary<sine>},
    FunctionEntry{"cos", unary<cosine>},
    FunctionEntry{"tan", unary<tan_degrees>},
    FunctionEntry{"asin", unary<asin_degrees>},
    FunctionEntry{"acos", unary<acos_degrees>},
    FunctionEntry{"atan", unary<atan_degrees>},
    FunctionEntry{"atan2", binary<atan2_degrees>},
    FunctionEntry{"floor", unary<floor_of>},
    FunctionEntry{"ceil", unary<ceil_of>},
    FunctionEntry{"round", unary<round_of>},
    FunctionEntry{"sqrt", unary<sqrt_of>},
    FunctionEntry{"exp", unary<exp_of>},
    FunctionEntry{"ln", unary<ln_of>},
    FunctionEntry{"log", log},
    FunctionEntry{"pow", binary<power>},
    FunctionEntry{"min", extreme<false>},
    FunctionEntry{"max", extreme<true>},
    FunctionEntry{"norm", norm},
    FunctionEntry{"cross", cross},
    FunctionEntry{"rands", rands},
};

}  // namespace

std::span<const FunctionEntry> math_functions() {
    return kMath;
}

BuiltinFunction find_builtin_function(std::string_view name) {
    for (const auto& table : {math_functions(), list_functions(), object_functions(), measure_functions()}) {
        const auto found =
            std::find_if(table.begin(), table.end(), [&](const FunctionEntry& e) { return e.name == name; });
        if (found != table.end()) {
            return found->function;
        }
    }
    return nullptr;
}

}  // namespace csg::scad
