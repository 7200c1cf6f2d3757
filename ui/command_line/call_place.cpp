#include "ui/command_line/call_place.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ui/command_line/usage_error.h"

namespace ui {

namespace {

struct Asked {
    std::string file;  ///< Empty: that of the first call, the input.
    std::uint32_t line = 0, column = 0;
};

/// Takes ":12" or "12" off the end.
std::optional<std::uint32_t> take_number(std::string& text) {
    const std::size_t colon = text.rfind(':');
    const std::string digits = colon == std::string::npos ? text : text.substr(colon + 1);
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size() || value == 0) {
        return std::nullopt;
    }
    text.resize(colon == std::string::npos ? 0 : colon);
    return value;
}

Asked read(const std::string& option, const std::string& text) {
    Asked asked;
    std::string rest = text;
    const auto last = take_number(rest);
    if (!last) {
        throw UsageError(fmt::format("{} {}: expected [FILE:]LINE[:COLUMN]", option, text));
    }
    asked.line = *last;
    if (const auto first = rest.empty() ? std::nullopt : take_number(rest)) {
        asked.column = asked.line;
        asked.line = *first;
    }
    asked.file = rest;
    return asked;
}

bool is_in(const std::string& path, const std::string& file) {
    return path == file || (path.ends_with(file) && path[path.size() - file.size() - 1] == '/');
}

}  // namespace

csg::SourceLocation call_at(const csg::Tree& tree, const std::vector<const csg::Statement*>& calls,
                            const std::string& option, const std::string& text, const char* what) {
    const Asked asked = read(option, text);
    std::vector<const csg::Statement*> of_file;
    for (const csg::Statement* const call : calls) {
        if (asked.file.empty() ? call->where.file == 0 : is_in(tree.files()[call->where.file], asked.file)) {
            of_file.push_back(call);
        }
    }
    for (const csg::Statement* const call : of_file) {
        if (call->where.line == asked.line && (asked.column == 0 || call->where.column == asked.column)) {
            return call->where;
        }
    }
    const auto distance = [&](const csg::Statement* call) {
        const auto line = static_cast<std::int64_t>(call->where.line);
        return std::abs(line - static_cast<std::int64_t>(asked.line));
    };
    std::ranges::stable_sort(of_file, {}, distance);
    constexpr std::size_t kMostNamed = 3;
    of_file.resize(std::min(of_file.size(), kMostNamed));
    std::vector<std::string> near;
    near.reserve(of_file.size());
    for (const csg::Statement* const call : of_file) {
        near.push_back(fmt::format("{}:{} ({})", call->where.line, call->where.column, call->name));
    }
    throw UsageError(fmt::format("{} {}: there is no {} that makes something.{}", option, text, what,
                                 near.empty() ? "" : fmt::format(" The nearest: {}.", fmt::join(near, ", "))));
}

std::vector<const csg::Statement*> all_calls(const csg::Tree& tree) {
    std::vector<const csg::Statement*> calls;
    for (const csg::Statement& statement : tree.statements()) {
        calls.push_back(&statement);
    }
    return calls;
}

}  // namespace ui
