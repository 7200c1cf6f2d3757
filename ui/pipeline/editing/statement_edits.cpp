#include "ui/pipeline/editing/statement_edits.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <fmt/format.h>

namespace ui {

namespace {

using csg::scad::ByteRange;

constexpr std::string_view kIndent = "    ";

/// As the first line of the text ends.
std::string_view line_end(std::string_view text) {
    const std::size_t at = text.find('\n');
    return at != std::string_view::npos && at > 0 && text[at - 1] == '\r' ? "\r\n" : "\n";
}

std::size_t line_begin(std::string_view text, std::size_t at) {
    const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    return before == std::string_view::npos ? 0 : before + 1;
}

/// The blanks that its line begins with.
std::string indentation(std::string_view text, std::size_t at) {
    const std::size_t begin = line_begin(text, at);
    const std::size_t end = std::min(text.find_first_not_of(" \t", begin), at);
    return std::string(text.substr(begin, end - begin));
}

std::string indented(std::string_view lines) {
    std::string result;
    for (const char c : lines) {
        result += c;
        if (c == '\n') {
            result += kIndent;
        }
    }
    return result;
}

StatementEdit put(const ByteRange& in_place_of, std::string text, std::size_t from, std::size_t length) {
    const std::size_t begin = in_place_of.begin + from;
    return {{in_place_of, std::move(text)}, {begin, begin + length}};
}

/// Behind the opening brace of "difference() {"; npos where it is something else.
std::size_t behind_difference(std::string_view statement) {
    constexpr std::string_view kName = "difference";
    if (!statement.starts_with(kName) || statement.back() != '}') {
        return std::string_view::npos;
    }
    std::size_t at = kName.size();
    for (const char sign : {'(', ')', '{'}) {
        at = statement.find_first_not_of(" \t\r\n", at);
        if (at == std::string_view::npos || statement[at] != sign) {
            return std::string_view::npos;
        }
        ++at;
    }
    return at;
}

constexpr std::array<std::string_view, 5> kOperations{"union", "difference", "intersection", "hull", "minkowski"};

bool is_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}

/// The operation that the statement is a call of; empty where it is none.
std::string_view operation_of(std::string_view statement) {
    const auto end = std::find_if_not(statement.begin(), statement.end(), is_name);
    const std::string_view name = statement.substr(0, static_cast<std::size_t>(end - statement.begin()));
    return std::find(kOperations.begin(), kOperations.end(), name) != kOperations.end() ? name : std::string_view();
}

/// Lines but for the first with as much less before them as they have more than `indent`, at most four blanks.
std::string outdented(std::string_view lines, std::size_t indent) {
    std::string result;
    for (std::size_t at = 0; at < lines.size();) {
        const std::size_t end = std::min(lines.find('\n', at), lines.size() - 1) + 1;
        std::string_view line = lines.substr(at, end - at);
        if (at > 0) {
            const std::size_t blanks = std::min(line.find_first_not_of(" \t"), line.size());
            const std::size_t more = blanks > indent ? blanks - indent : 0;
            const bool tab = line.starts_with('\t');
            line.remove_prefix(tab ? std::min<std::size_t>(more, 1) : std::min(more, kIndent.size()));
        }
        result += line;
        at = end;
    }
    return result;
}

}  // namespace

StatementEdit append_statement(std::string_view text, std::string_view statement) {
    const std::string end(line_end(text));
    const std::string before = text.empty() || text.back() == '\n' ? "" : end;
    return put({text.size(), text.size()}, before + std::string(statement) + end, before.size(), statement.size());
}

StatementEdit double_statement(std::string_view text, const StatementText& statement) {
    const auto [begin, end] = statement.bytes;
    const std::string copy(text.substr(begin, end - begin));
    const std::string next = std::string(line_end(text)) + indentation(text, begin);
    if (!statement.sole) {
        return put({end, end}, next + copy, next.size(), copy.size());
    }
    const std::string inner = indented(copy), first = "{" + next + std::string(kIndent) + inner;
    const std::string gap = next + std::string(kIndent);
    return put(statement.bytes, first + gap + inner + next + "}", first.size() + gap.size(), inner.size());
}

StatementEdit delete_statement(std::string_view text, const StatementText& statement) {
    if (statement.sole) {
        return put(statement.bytes, ";", 0, 0);
    }
    const std::size_t begin = line_begin(text, statement.bytes.begin);
    std::size_t end = text.find_first_not_of(" \t\r", statement.bytes.end);
    end = end == std::string_view::npos ? text.size() : end;
    const bool alone =
        text.find_first_not_of(" \t", begin) == statement.bytes.begin && (end == text.size() || text[end] == '\n');
    return put(alone ? ByteRange{begin, std::min(end + 1, text.size())} : statement.bytes, "", 0, 0);
}

StatementEdit subtract_from_statement(std::string_view text, const StatementText& statement,
                                      std::string_view subtracted) {
    const auto [begin, end] = statement.bytes;
    const std::string_view before = text.substr(begin, end - begin);
    const std::string next = std::string(line_end(text)) + indentation(text, begin);
    const std::string inner = next + std::string(kIndent);
    if (const std::size_t behind = behind_difference(before); behind != std::string_view::npos) {
        // Behind the last child, and the comments after it.
        std::size_t last = before.find_last_not_of(" \t\r\n", before.size() - 2) + 1;
        last = std::max(last, behind);
        return put({begin + last, begin + last}, inner + std::string(subtracted), inner.size(), subtracted.size());
    }
    const std::string first = "difference() {" + inner + indented(before) + inner;
    return put(statement.bytes, first + std::string(subtracted) + next + "}", first.size(), subtracted.size());
}

StatementEdit put_before_statement(const StatementText& statement, std::string_view calls) {
    const auto [begin, end] = statement.bytes;
    return {{{begin, begin}, std::string(calls)}, {begin, end + calls.size()}};
}

StatementEdit group_statement(std::string_view text, const StatementText& statement, std::string_view call) {
    const auto [begin, end] = statement.bytes;
    const std::string next = std::string(line_end(text)) + indentation(text, begin);
    const std::string all =
        std::string(call) + " {" + next + std::string(kIndent) + indented(text.substr(begin, end - begin)) + next + "}";
    return put(statement.bytes, all, 0, all.size());
}

std::optional<StatementEdit> ungroup_statement(std::string_view text, const StatementText& statement) {
    const auto [begin, end] = statement.bytes;
    const std::string_view all = text.substr(begin, end - begin);
    const std::size_t brace = all.find('{');
    if (statement.sole || operation_of(all).empty() || all.back() != '}' || brace == std::string_view::npos ||
        all.substr(0, brace).find(';') != std::string_view::npos) {
        return std::nullopt;
    }
    const std::size_t first = all.find_first_not_of(" \t\r\n", brace + 1);
    const std::size_t last = all.find_last_not_of(" \t\r\n", all.size() - 2);
    if (first >= all.size() - 1 || last < first) {
        return std::nullopt;
    }
    const std::string children = outdented(all.substr(first, last + 1 - first), indentation(text, begin).size());
    return put(statement.bytes, children, 0, children.size());
}

std::optional<StatementEdit> change_operation(std::string_view text, const StatementText& statement,
                                              std::string_view name) {
    const auto [begin, end] = statement.bytes;
    const std::string_view before = operation_of(text.substr(begin, end - begin));
    if (before.empty() || before == name) {
        return std::nullopt;
    }
    return StatementEdit{{{begin, begin + before.size()}, std::string(name)},
                         {begin, end + name.size() - before.size()}};
}

StatementEdit toggle_modifier(std::string_view text, const StatementText& statement, char modifier) {
    const auto [begin, end] = statement.bytes;
    const std::size_t calls = std::min(text.find_first_not_of("#%!* \t", begin), end);
    const std::size_t there = text.find(modifier, begin);
    if (there < calls) {
        return {{{there, there + 1}, ""}, {begin, end - 1}};
    }
    return {{{begin, begin}, std::string(1, modifier)}, {begin, end + 1}};
}

std::string loop_variable(std::string_view text, const StatementText& statement) {
    const std::string_view all = text.substr(statement.bytes.begin, statement.bytes.end - statement.bytes.begin);
    const auto occurs = [&](const std::string& name) {
        for (std::size_t at = all.find(name); at != std::string_view::npos; at = all.find(name, at + 1)) {
            const std::size_t behind = at + name.size();
            if ((at == 0 || !is_name(all[at - 1])) && (behind >= all.size() || !is_name(all[behind]))) {
                return true;
            }
        }
        return false;
    };
    for (const char* const name : {"i", "j", "k", "n"}) {
        if (!occurs(name)) {
            return name;
        }
    }
    for (int number = 2;; ++number) {
        if (std::string name = fmt::format("i{}", number); !occurs(name)) {
            return name;
        }
    }
}

}  // namespace ui
