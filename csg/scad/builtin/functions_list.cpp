// Built-in functions of lists, strings and types.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "csg/scad/builtin/builtin_functions.h"
#include "csg/scad/value/object.h"

namespace csg::scad {

namespace {

template <ValueType kType>
Value is_type(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 1, 1, "1", host)) {
        return {};
    }
    return a[0].type() == kType && !(kType == ValueType::Number && std::isnan(a[0].number()));
}

Value len(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 1, 1, "1", host)) {
        return {};
    }
    if (a[0].is_vector()) {
        return static_cast<double>(a[0].elements().size());
    }
    if (a[0].is_object()) {
        return static_cast<double>(a[0].entries().size());
    }
    if (!check_type(name, a, 0, ValueType::String, host)) {
        return {};
    }
    return static_cast<double>(a[0].length());
}

Value concat(std::string_view, std::span<const Value> a, FunctionHost&) {
    std::vector<Value> result;
    for (const Value& value : a) {
        if (value.is_vector()) {
            note_values(value.elements().size());
            result.insert(result.end(), value.elements().begin(), value.elements().end());
        } else {
            result.push_back(value);
        }
    }
    return result;
}

Value str(std::string_view, std::span<const Value> a, FunctionHost&) {
    std::string result;
    for (const Value& value : a) {
        result += value.text();
    }
    return result;
}

/// `left` bounds how much of all lists together is looked at.
void append_characters(std::string& out, const Value& value, std::size_t limit, std::size_t& left, int depth = 0) {
    const auto append = [&out](double c) {
        if (c >= 1 && c < 0x110000 && !(c >= 0xd800 && c < 0xe000)) {
            append_utf8(out, static_cast<char32_t>(c));
        }
    };
    constexpr int kMaxDepth = 1000;
    if (value.is_number()) {
        append(value.number());
    } else if (value.is_vector() && depth < kMaxDepth) {
        for (const Value& e : value.elements()) {
            if (left-- == 0) {
                throw ValueLimit("A list is too long to be converted to text");
            }
            note_values(1);
            append_characters(out, e, limit, left, depth + 1);
        }
    } else if (value.is_range()) {
        const std::uint32_t count = value.range().count();
        for (std::uint32_t i = 0; i < count && count < limit; ++i) {
            append(value.range().at(i));
        }
    }
}

Value chr(std::string_view, std::span<const Value> a, FunctionHost& host) {
    constexpr std::uint32_t kMaxRange = 1'000'000;
    std::size_t left = 50'000'000;
    std::string result;
    for (const Value& value : a) {
        if (value.is_range() && value.range().count() >= kMaxRange) {
            host.warn(fmt::format("chr() parameter could not be converted: argument 0: expected no more than {} items",
                                  kMaxRange));
            return {};
        }
        append_characters(result, value, kMaxRange, left);
    }
    return result;
}

Value ord(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 1, 1, "1", host) || !check_type(name, a, 0, ValueType::String, host) ||
        a[0].string().empty()) {
        return {};
    }
    const std::string& text = a[0].string();
    if (!is_valid_utf8(text)) {
        host.warn(fmt::format("ord() argument '{}' is not a valid utf8 string", text));
        return {};
    }
    return static_cast<double>(decode_code_point(a[0].string(), 0));
}

Value lookup(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 2, 2, "2", host) || !check_type(name, a, 0, ValueType::Number, host) ||
        !check_type(name, a, 1, ValueType::Vector, host)) {
        return {};
    }
    const double p = a[0].number();
    if (!std::isfinite(p)) {
        host.warn(fmt::format("lookup({}, ...) first argument is not a number", a[0].echo_text()));
        return {};
    }
    using Entry = std::array<double, 2>;
    const auto entry = [](const Value& v) -> std::optional<Entry> {
        if (!v.is_vector() || v.elements().size() != 2 || !v.elements()[0].is_number() ||
            !v.elements()[1].is_number()) {
            return std::nullopt;
        }
        return Entry{v.elements()[0].number(), v.elements()[1].number()};
    };
    const auto table = a[1].elements();
    note_values(table.size());
    const auto first = table.empty() ? std::nullopt : entry(table[0]);
    if (!first) {
        return {};
    }
    Entry low = *first, high = *first;
    for (const Value& row : table.subspan(1)) {
        if (const auto e = entry(row)) {
            if ((*e)[0] <= p && ((*e)[0] > low[0] || low[0] > p)) {
                low = *e;
            }
            if ((*e)[0] >= p && ((*e)[0] < high[0] || high[0] < p)) {
                high = *e;
            }
        }
    }
    if (p <= low[0]) {
        return high[1];
    }
    if (p >= high[0]) {
        return low[1];
    }
    const double f = (p - low[0]) / (high[0] - low[0]);
    return high[1] * f + low[1] * (1 - f);
}

std::vector<std::string_view> characters(std::string_view text) {
    std::vector<std::string_view> result;
    for (std::size_t at = 0; at < text.size(); at += result.back().size()) {
        result.push_back(text.substr(at, code_point_bytes(text, at)));
    }
    return result;
}

/// To be called at every row of a table, of which it notes many at once.
void note_rows(std::size_t row) {
    constexpr std::size_t kAtOnce = 64;
    if (row % kAtOnce == 0) {
        note_values(kAtOnce);
    }
}

/// The rows that `matches`, as search() returns them for one thing sought: with `per_match` 1 the first index goes
/// to `result` itself, else a list of up to `per_match` (0: of all) does.
template <typename Matches>
void search_one(std::vector<Value>& result, std::size_t rows, std::size_t per_match, bool list_if_none,
                Matches&& matches) {
    std::vector<Value> found;
    for (std::size_t row = 0; row < rows && (per_match == 0 || found.size() < per_match); ++row) {
        note_rows(row);
        if (matches(row)) {
            found.emplace_back(static_cast<double>(row));
        }
    }
    if (per_match == 1 && !found.empty()) {
        result.push_back(std::move(found[0]));
    } else if (per_match != 1 || list_if_none) {
        result.emplace_back(std::move(found));
    }
}

Value search(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 2, 4, "between 2 and 4", host)) {
        return {};
    }
    // Cast as C does on the usual machines: negative numbers become large ones.
    const auto natural = [&](std::size_t i, std::size_t otherwise) {
        const bool small = i < a.size() && a[i].is_number() && std::abs(a[i].number()) < 0x1p63;
        return i >= a.size() ? otherwise
               : small       ? static_cast<std::uint32_t>(static_cast<std::int64_t>(a[i].number()))
                             : 0;
    };
    const std::size_t per_match = natural(2, 1), column = natural(3, 0);
    const Value &sought = a[0], &table = a[1];
    const auto rows = table.is_vector() ? table.elements() : std::span<const Value>();
    const auto row_equals = [&](const Value& value, std::size_t row) {
        const Value& r = rows[row];
        return (column == 0 && equal(value, r)) ||
               (r.is_vector() && column < r.elements().size() && equal(value, r.elements()[column]));
    };
    std::vector<Value> result;
    if (sought.is_number()) {
        for (std::size_t row = 0; row < rows.size() && (per_match == 0 || result.size() < per_match); ++row) {
            note_rows(row);
            if (row_equals(sought, row)) {
                result.emplace_back(static_cast<double>(row));
            }
        }
        return result;
    }
    if (sought.is_vector()) {
        for (const Value& value : sought.elements()) {
            search_one(result, rows.size(), per_match, true, [&](std::size_t row) { return row_equals(value, row); });
        }
        return result;
    }
    if (!sought.is_string()) {
        return {};
    }
    if (table.is_string()) {
        const auto text = characters(table.string());
        for (const std::string_view c : characters(sought.string())) {
            search_one(result, text.size(), per_match, false, [&](std::size_t row) { return text[row] == c; });
        }
        return result;
    }
    std::optional<std::size_t> too_short;
    for (const std::string_view c : characters(sought.string())) {
        search_one(result, rows.size(), per_match, false, [&](std::size_t row) {
            if (too_short || !rows[row].is_vector() || rows[row].elements().size() <= column) {
                too_short = too_short.value_or(row);
                return false;
            }
            const Value& cell = rows[row].elements()[column];
            return cell.is_string() && !cell.string().empty() &&
                   std::string_view(cell.string()).substr(0, code_point_bytes(cell.string(), 0)) == c;
        });
        if (too_short) {
            host.warn(
                fmt::format("Invalid entry in search vector at index {}, required number of values in the entry: "
                            "{}. Invalid entry: {}",
                            *too_short, static_cast<std::uint32_t>(column + 1), rows[*too_short].echo_text()));
            return std::vector<Value>();
        }
    }
    return result;
}

/// Of the OpenSCAD whose language this is: its suite of that month holds (docs/COMPATIBILITY.md).
Value version(std::string_view, std::span<const Value>, FunctionHost&) {
    return std::vector<Value>{2026, 7, 1};
}

Value version_num(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    const Value v = a.empty() ? version(name, a, host) : a[0];
    if (!v.is_vector() || v.elements().size() < 2 || v.elements().size() > 3) {
        return {};
    }
    const auto parts = v.elements();
    if (!std::all_of(parts.begin(), parts.end(), [](const Value& part) { return part.is_number(); })) {
        return {};
    }
    return parts[0].number() * 10000 + parts[1].number() * 100 + (parts.size() == 3 ? parts[2].number() : 0);
}

Value parent_module(std::string_view name, std::span<const Value> a, FunctionHost& host) {
    if (!check_count(name, a, 0, 1, "0 or 1", host) ||
        (a.size() == 1 && !check_type(name, a, 0, ValueType::Number, host))) {
        return {};
    }
    ++host.effects;
    const double n = a.empty() ? 1 : std::trunc(a[0].number());
    if (n < 0) {
        host.warn(fmt::format("Negative parent module index ({:.0f}) not allowed", n));
        return {};
    }
    if (!(n < static_cast<double>(host.module_names.size()))) {
        host.warn(fmt::format("Parent module index ({:.0f}) greater than the number of modules on the stack", n));
        return {};
    }
    return std::string(host.module_names[host.module_names.size() - 1 - static_cast<std::size_t>(n)]);
}

constexpr std::array kLists{
    FunctionEntry{"is_undef", is_type<ValueType::Undef>},
    FunctionEntry{"is_bool", is_type<ValueType::Bool>},
    FunctionEntry{"is_num", is_type<ValueType::Number>},
    FunctionEntry{"is_string", is_type<ValueType::String>},
    FunctionEntry{"is_list", is_type<ValueType::Vector>},
    FunctionEntry{"is_function", is_type<ValueType::Function>},
    FunctionEntry{"len", len},
    FunctionEntry{"concat", concat},
    FunctionEntry{"str", str},
    FunctionEntry{"chr", chr},
    FunctionEntry{"ord", ord},
    FunctionEntry{"lookup", lookup},
    FunctionEntry{"search", search},
    FunctionEntry{"version", version},
    FunctionEntry{"version_num", version_num},
    FunctionEntry{"parent_module", parent_module},
};

}  // namespace

std::span<const FunctionEntry> list_functions() {
    return kLists;
}

}  // namespace csg::scad
