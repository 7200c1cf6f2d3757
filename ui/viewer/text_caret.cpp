#include "ui/viewer/text_caret.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <utility>

namespace ui {

namespace {

constexpr std::size_t kIndent = 4;

bool continues(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;  // Of a character of several bytes.
}

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$' ||
           (static_cast<unsigned char>(c) & 0x80U) != 0;
}

std::size_t line_begin(const std::string& text, std::size_t at) {
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    return before == std::string::npos ? 0 : before + 1;
}

std::size_t line_end(const std::string& text, std::size_t at) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    return end > at && text[end - 1] == '\r' ? end - 1 : end;
}

std::size_t right_of(const std::string& text, std::size_t at) {
    if (at < text.size()) {
        at += text.compare(at, 2, "\r\n") == 0 ? 2 : 1;
    }
    while (at < text.size() && continues(text[at])) {
        ++at;
    }
    return at;
}

std::size_t left_of(const std::string& text, std::size_t at) {
    if (at == 0) {
        return 0;
    }
    --at;
    while (at > 0 && continues(text[at])) {
        --at;
    }
    return at > 0 && text[at] == '\n' && text[at - 1] == '\r' ? at - 1 : at;
}

}  // namespace

void TextCaret::put(std::size_t at, bool more) {
    at_ = at;
    anchor_ = more ? anchor_ : at;
    keeps_ = false;
}

void TextCaret::select(std::size_t from, std::size_t to) {
    anchor_ = from;
    at_ = to;
    keeps_ = false;
}

void TextCaret::select_word(const std::string& text, std::size_t at) {
    std::size_t from = at, to = at;
    while (from > 0 && is_word(text[from - 1])) {
        --from;
    }
    while (to < text.size() && is_word(text[to])) {
        ++to;
    }
    select(from, from == to ? right_of(text, at) : to);
}

void TextCaret::keep_within(const std::string& text) {
    at_ = std::min(at_, text.size());
    anchor_ = std::min(anchor_, text.size());
}

std::size_t TextCaret::destination(const std::string& text, Way way) const {
    std::size_t at = at_;
    switch (way) {
        case Way::Left:
            return left_of(text, at);
        case Way::Right:
            return right_of(text, at);
        case Way::WordLeft:
            while (at > 0 && !is_word(text[at - 1])) {
                --at;
            }
            while (at > 0 && is_word(text[at - 1])) {
                --at;
            }
            return at;
        case Way::WordRight:
            while (at < text.size() && is_word(text[at])) {
                ++at;
            }
            while (at < text.size() && !is_word(text[at])) {
                ++at;
            }
            return at;
        case Way::LineBegin: {
            // The first character; from there, the begin of the line.
            const std::size_t begin = line_begin(text, at);
            const std::size_t first = std::min(text.find_first_not_of(" \t", begin), line_end(text, begin));
            return at == first ? begin : first;
        }
        case Way::LineEnd:
            return line_end(text, at);
        case Way::Begin:
            return 0;
        case Way::End:
            return text.size();
        case Way::Up:
        case Way::Down:
            break;
    }
    return at;
}

void TextCaret::move_lines(const std::string& text, int lines) {
    std::size_t begin = line_begin(text, at_);
    if (!std::exchange(keeps_, true)) {
        column_ = 0;
        for (std::size_t at = begin; at < at_; at = right_of(text, at)) {
            ++column_;
        }
    }
    for (int i = 0; i < std::abs(lines); ++i) {
        if (lines > 0) {
            const std::size_t end = text.find('\n', begin);
            if (end == std::string::npos) {
                at_ = text.size();
                return;
            }
            begin = end + 1;
        } else {
            if (begin == 0) {
                at_ = 0;
                return;
            }
            begin = line_begin(text, begin - 1);
        }
    }
    at_ = begin;
    const std::size_t end = line_end(text, begin);
    for (std::size_t i = 0; i < column_ && at_ < end; ++i) {
        at_ = right_of(text, at_);
    }
}

void TextCaret::move(const std::string& text, Way way, bool more, int lines) {
    if (way == Way::Up || way == Way::Down) {
        move_lines(text, way == Way::Up ? -lines : lines);
    } else if (!more && selects() && (way == Way::Left || way == Way::Right)) {
        put(way == Way::Left ? begin() : end(), false);
    } else {
        at_ = destination(text, way);
        keeps_ = false;
    }
    anchor_ = more ? anchor_ : at_;
}

void TextCaret::insert(std::string& text, std::string_view typed) {
    text.replace(begin(), end() - begin(), typed);
    put(begin() + typed.size(), false);
}

void TextCaret::erase(std::string& text, Way way) {
    if (!selects()) {
        anchor_ = destination(text, way);
    }
    insert(text, "");
}

void TextCaret::new_line(std::string& text) {
    const std::size_t from = line_begin(text, begin());
    const std::size_t blanks = std::min(text.find_first_not_of(" \t", from), begin());
    std::string typed = "\n" + text.substr(from, blanks - from);
    if (begin() > 0 && std::string_view("{([").find(text[begin() - 1]) != std::string_view::npos) {
        typed.append(kIndent, ' ');
    }
    const std::size_t first = text.find('\n');
    if (first != std::string::npos && first > 0 && text[first - 1] == '\r') {
        typed.insert(0, "\r");
    }
    insert(text, typed);
}

void TextCaret::indent(std::string& text, bool less) {
    if (!selects() && !less) {
        insert(text, std::string(kIndent, ' '));
        return;
    }
    std::size_t from = line_begin(text, begin()), to = end();
    const bool forwards = anchor_ <= at_;
    const std::size_t first = from;
    do {
        const std::size_t there = std::min(text.find_first_not_of(' ', from), text.size()) - from;
        const std::size_t count = less ? std::min(there, kIndent) : kIndent;
        less ? (void)text.erase(from, count) : (void)text.insert(from, count, ' ');
        to = less ? std::max(to - std::min(to, count), first) : to + count;
        from = text.find('\n', from);
        from = from == std::string::npos ? text.size() : from + 1;
    } while (from < to);
    forwards ? select(first, to) : select(to, first);
    keep_within(text);
}

std::string highlighted(std::string_view text) {
    static constexpr std::array<std::string_view, 17> kKeywords{
        "module", "function", "if",    "else",  "for",     "let", "assert",           "echo",
        "each",   "true",     "false", "undef", "include", "use", "intersection_for", "children",
        "PI"};
    std::string kinds(text.size(), ' ');
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at + 1;
        char kind = ' ';
        const char c = text[at];
        if (text.substr(at, 2) == "//") {
            kind = 'c';
            end = std::min(text.find('\n', at), text.size());
        } else if (text.substr(at, 2) == "/*") {
            kind = 'c';
            const std::size_t close = text.find("*/", at + 2);
            end = close == std::string_view::npos ? text.size() : close + 2;
        } else if (c == '"') {
            kind = 's';
            while (end < text.size() && text[end] != '"') {
                end += text[end] == '\\' ? 2 : 1;
            }
            end = std::min(end + 1, text.size());
        } else if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
            kind = 'n';
            while (end < text.size() && (is_word(text[end]) || text[end] == '.' ||
                                         ((text[end] == '-' || text[end] == '+') && (text[end - 1] | 32) == 'e'))) {
                ++end;
            }
        } else if (is_word(c)) {
            while (end < text.size() && is_word(text[end])) {
                ++end;
            }
            const std::string_view word = text.substr(at, end - at);
            const std::size_t next = text.find_first_not_of(" \t", end);
            const bool calls = next != std::string_view::npos && text[next] == '(';
            kind = std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end() ? 'k'
                   : c == '$'                                                             ? '$'
                   : calls                                                                ? 'f'
                                                                                          : ' ';
        }
        std::fill(kinds.begin() + static_cast<std::ptrdiff_t>(at), kinds.begin() + static_cast<std::ptrdiff_t>(end),
                  kind);
        at = end;
    }
    return kinds;
}

}  // namespace ui
