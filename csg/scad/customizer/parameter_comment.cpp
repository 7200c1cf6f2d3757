#include "csg/scad/customizer/parameter_comment.h"

#include <charconv>
#include <optional>

#include "csg/scad/value/quoted.h"
#include "csg/scad/value/value.h"

namespace csg::scad {
namespace {

enum class CommentTokenKind : std::uint8_t { End, Number, Word, Open, Close, Comma, Colon };

struct CommentToken {
    CommentTokenKind kind = CommentTokenKind::End;
    std::string text;
    double number = 0;
};

bool separates(char c) {
    return std::string_view(" \n\r()[],:\"").find(c) != std::string_view::npos;
}

std::optional<double> as_number(std::string_view word) {
    const bool signed_plus = word.starts_with('+');
    std::string_view digits = word;
    digits.remove_prefix(signed_plus || word.starts_with('-') ? 1 : 0);
    if (digits.empty() || std::string_view(".0123456789").find(digits[0]) == std::string_view::npos) {
        return std::nullopt;  // "inf" is a word.
    }
    word.remove_prefix(signed_plus ? 1 : 0);
    double number = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), number);
    if (result.ec != std::errc() || result.ptr != word.data() + word.size()) {
        return std::nullopt;
    }
    return number;
}

/// What stands in quotes, as one word; `at` is the first quote. A quote that nothing closes reaches to the end.
std::string quoted_word(std::string_view text, std::size_t& at) {
    std::string word;
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] != '\\' || at + 1 == text.size()) {
            word += text[at];
            continue;
        }
        const char c = text[++at];
        word += c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c;
    }
    at += at < text.size() ? 1 : 0;
    return word;
}

std::vector<CommentToken> tokens_of(std::string_view text) {
    std::vector<CommentToken> tokens;
    for (std::size_t at = 0; at < text.size();) {
        switch (text[at]) {
            case ' ':
            case '\n':
            case '\r':
            case '(':
            case ')':
                ++at;
                continue;
            case '[':
                tokens.push_back({CommentTokenKind::Open, "", 0}), ++at;
                continue;
            case ']':
                tokens.push_back({CommentTokenKind::Close, "", 0}), ++at;
                continue;
            case ',':
                tokens.push_back({CommentTokenKind::Comma, "", 0}), ++at;
                continue;
            case ':':
                tokens.push_back({CommentTokenKind::Colon, "", 0}), ++at;
                continue;
            case '"':
                tokens.push_back({CommentTokenKind::Word, quoted_word(text, at), 0});
                continue;
            default:
                break;
        }
        const std::size_t begin = at;
        while (at < text.size() && !separates(text[at])) {
            ++at;
        }
        const std::string_view word = text.substr(begin, at - begin);
        const std::optional<double> number = as_number(word);
        tokens.push_back(
            {number ? CommentTokenKind::Number : CommentTokenKind::Word, std::string(word), number.value_or(0)});
    }
    tokens.emplace_back();
    return tokens;
}

/// Each function gives nothing where the comment has another form.
class CommentParser {
  public:
    explicit CommentParser(std::string_view text) : tokens_(tokens_of(text)) {}

    std::optional<CommentValue> parse() {
        std::optional<CommentValue> value = accept(CommentTokenKind::Open) ? list() : phrase();
        return value && at(CommentTokenKind::End) ? value : std::nullopt;
    }

  private:
    [[nodiscard]] bool at(CommentTokenKind kind) const { return tokens_[next_].kind == kind; }
    bool accept(CommentTokenKind kind) {
        const bool is = at(kind);
        next_ += is ? 1 : 0;
        return is;
    }

    /// A number alone, or words with numbers among them.
    std::optional<CommentValue> phrase() {
        CommentValue value;
        std::size_t count = 0;
        bool words = false;
        for (; at(CommentTokenKind::Word) || at(CommentTokenKind::Number); ++next_, ++count) {
            const CommentToken& token = tokens_[next_];
            value.text += (count > 0 ? " " : "") + token.text;
            value.number = token.number;
            words |= token.kind == CommentTokenKind::Word;
        }
        if (count == 0 || (!words && count > 1)) {
            return std::nullopt;
        }
        if (!words) {
            value.kind = CommentValue::Kind::Number;
            value.text.clear();
        }
        return value;
    }

    /// One element: a phrase, or up to three of them with colons between.
    std::optional<CommentValue> element() {
        CommentValue parts;
        parts.kind = CommentValue::Kind::List;
        for (;;) {
            std::optional<CommentValue> part = phrase();
            if (!part) {
                return std::nullopt;
            }
            parts.items.push_back(std::move(*part));
            if (parts.items.size() == 3 || !at(CommentTokenKind::Colon)) {
                return parts.items.size() == 1 ? std::move(parts.items[0]) : std::move(parts);
            }
            ++next_;
        }
    }

    static bool is_range(const CommentValue& parts) {
        for (const CommentValue& item : parts.items) {
            if (item.kind != CommentValue::Kind::Number) {
                return false;
            }
        }
        return parts.kind == CommentValue::Kind::List;
    }

    std::optional<CommentValue> list() {
        CommentValue list;
        list.kind = CommentValue::Kind::List;
        do {
            std::optional<CommentValue> item = element();
            if (!item) {
                return std::nullopt;
            }
            list.items.push_back(std::move(*item));
        } while (accept(CommentTokenKind::Comma));
        if (!accept(CommentTokenKind::Close)) {
            return std::nullopt;
        }
        if (list.items.size() == 1 && is_range(list.items[0])) {
            CommentValue range = std::move(list.items[0]);
            range.kind = CommentValue::Kind::Range;
            return range;
        }
        for (const CommentValue& item : list.items) {
            if (item.items.size() == 3) {
                return std::nullopt;
            }
        }
        return list;
    }

    std::vector<CommentToken> tokens_;
    std::size_t next_ = 0;
};

}  // namespace

CommentValue parse_parameter_comment(std::string_view comment) {
    if (comment.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        return {};
    }
    return CommentParser(comment).parse().value_or(CommentValue{});
}

std::string comment_value_text(const CommentValue& value) {
    switch (value.kind) {
        case CommentValue::Kind::Text:
            return quoted(value.text);
        case CommentValue::Kind::Number:
            return number_text(value.number);
        default:
            break;
    }
    std::string text = "[";
    for (const CommentValue& item : value.items) {  // At most one level deeper: lists of pairs.
        text += text.size() == 1 ? "" : value.kind == CommentValue::Kind::Range ? " : " : ", ";
        text += comment_value_text(item);
    }
    return text + ']';
}

}  // namespace csg::scad
