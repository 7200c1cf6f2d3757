#include "ui/pipeline/editing/statement_edits.h"

#include <algorithm>
#include <utility>

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

}  // namespace ui
