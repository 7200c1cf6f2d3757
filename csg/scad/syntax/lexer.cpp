#include "csg/scad/syntax/lexer.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "csg/scad/source/characters.h"
#include "csg/scad/value/value.h"

namespace csg::scad {
namespace {

TokenKind sign_of_two(char first, char second) {
    switch (first) {
        case '<':
            return second == '=' ? TokenKind::LessEqual : second == '<' ? TokenKind::ShiftLeft : TokenKind::End;
        case '>':
            return second == '=' ? TokenKind::GreaterEqual : second == '>' ? TokenKind::ShiftRight : TokenKind::End;
        case '=':
            return second == '=' ? TokenKind::Equal : TokenKind::End;
        case '!':
            return second == '=' ? TokenKind::NotEqual : TokenKind::End;
        case '&':
            return second == '&' ? TokenKind::And : TokenKind::End;
        case '|':
            return second == '|' ? TokenKind::Or : TokenKind::End;
        default:
            return TokenKind::End;
    }
}

constexpr TokenKind sign_of_one(char c) {
    switch (c) {
        case '(':
            return TokenKind::ParenOpen;
        case ')':
            return TokenKind::ParenClose;
        case '[':
            return TokenKind::BracketOpen;
        case ']':
            return TokenKind::BracketClose;
        case '{':
            return TokenKind::BraceOpen;
        case '}':
            return TokenKind::BraceClose;
        case ',':
            return TokenKind::Comma;
        case ';':
            return TokenKind::Semicolon;
        case ':':
            return TokenKind::Colon;
        case '?':
            return TokenKind::Question;
        case '.':
            return TokenKind::Dot;
        case '=':
            return TokenKind::Assign;
        case '!':
            return TokenKind::Not;
        case '#':
            return TokenKind::Hash;
        case '%':
            return TokenKind::Percent;
        case '*':
            return TokenKind::Star;
        case '+':
            return TokenKind::Plus;
        case '-':
            return TokenKind::Minus;
        case '/':
            return TokenKind::Slash;
        case '^':
            return TokenKind::Caret;
        case '~':
            return TokenKind::Tilde;
        case '<':
            return TokenKind::Less;
        case '>':
            return TokenKind::Greater;
        case '&':
            return TokenKind::BitAnd;
        case '|':
            return TokenKind::BitOr;
        default:
            return TokenKind::End;
    }
}

/// Signs that begin no longer one, and no number.
class LoneSigns {
  public:
    constexpr LoneSigns() {
        for (const char c : std::string_view("()[]{},;:?#%*+-/^~")) {
            kinds_[static_cast<unsigned char>(c)] = sign_of_one(c);
        }
    }
    [[nodiscard]] TokenKind of(char c) const { return kinds_[static_cast<unsigned char>(c)]; }

  private:
    std::array<TokenKind, 256> kinds_{};  // End, by default.
};
constexpr LoneSigns kLoneSigns;

}  // namespace

Lexer::Lexer(std::string_view text, std::uint32_t file, SymbolTable& symbols, const MessageSink& sink)
    : Lexer(text, file, symbols, sink, Place{}) {}

Lexer::Lexer(std::string_view text, std::uint32_t file, SymbolTable& symbols, const MessageSink& sink,
             const Place& begin)
    : text_(text), file_(file), symbols_(symbols), sink_(sink), place_(begin) {}

void Lexer::go_on(Place from, std::size_t at) {
    place_ = from;
    const char* const end = text_.data() + at;
    for (const char* line = end_of_line(text_.data() + from.at, end); line != end; line = end_of_line(line, end)) {
        line += line[0] == '\r' && line[1] == '\n' ? 2 : 1;
        ++place_.line;
        place_.line_start = static_cast<std::size_t>(line - text_.data());
    }
    place_.at = at;
}

SourceRange Lexer::since(const Place& begin) const {
    return {file_, begin.line, static_cast<std::uint32_t>(begin.at - begin.line_start) + 1, place_.line, column()};
}

Token Lexer::finish(TokenKind kind, const Place& begin) const {
    Token token;
    token.kind = kind;
    token.at = static_cast<std::uint32_t>(begin.at);
    token.where = since(begin);
    return token;
}

Token Lexer::error(const Place& begin, std::string_view text) {
    failed_ = finish(TokenKind::Error, begin);
    failed_.name = symbols_.intern(text);
    return failed_;
}

void Lexer::warn(const SourceRange& where, std::string text) const {
    report(sink_, {Severity::Warning, where, std::move(text), true});
}

void Lexer::advance() {
    const char c = text_[place_.at++];
    if (c == '\n' || c == '\r') {
        place_.at += c == '\r' && peek() == '\n' ? 1 : 0;
        ++place_.line;
        place_.line_start = place_.at;
    }
}

/// Besides ASCII white space: the no-break space, in UTF-8 and in Latin-1, and the byte order mark.
std::size_t Lexer::blank_bytes() const {
    switch (peek()) {
        case ' ':
        case '\t':
        case '\n':
        case '\r':
        case '\f':
        case '\v':
        case '\xA0':
            return 1;
        case '\xC2':
            return peek(1) == '\xA0' ? 2 : 0;
        case '\xEF':
            return peek(1) == '\xBB' && peek(2) == '\xBF' ? 3 : 0;
        default:
            return 0;
    }
}

bool Lexer::skip_comment() {
    const char* const end = text_.data() + text_.size();
    if (peek(1) == '/') {
        // A carriage return alone is a line's end to those who count lines, but no comment's, as in OpenSCAD.
        const char* line = end_of_line(text_.data() + place_.at, end);
        while (line != end && *line == '\r' && line[1] != '\n') {
            ++place_.line;
            place_.line_start = static_cast<std::size_t>(line + 1 - text_.data());
            line = end_of_line(line + 1, end);
        }
        place_.at = static_cast<std::size_t>(line - text_.data());
        return true;
    }
    place_.at += 2;
    while (!at_end()) {
        if (peek() == '*' && peek(1) == '/') {
            place_.at += 2;
            return true;
        }
        advance();
    }
    return false;
}

bool Lexer::skip_blanks() {
    const char* const end = text_.data() + text_.size();
    while (!at_end()) {
        const char c = text_[place_.at];
        if (c == ' ') {
            place_.at = static_cast<std::size_t>(end_of_spaces(text_.data() + place_.at + 1, end) - text_.data());
        } else if (c == '\n') {
            ++place_.line;
            place_.line_start = ++place_.at;
        } else if (c > ' ' && (c != '/' || (peek(1) != '/' &&
                                            peek(1) != '*'))) {  // NOLINT(bugprone-branch-clone): what is usual first.
            break;
        } else if (c == '/') {
            const Place begin = place_;
            if (!skip_comment()) {
                place_ = begin;
                place_.at += 2;
                error(begin, "unterminated comment: expected '*/' before the end of the file");
                return false;
            }
        } else if (const std::size_t bytes = blank_bytes(); bytes == 1) {
            advance();
        } else if (bytes > 1) {
            place_.at += bytes;
        } else {
            break;
        }
    }
    return true;
}

Token Lexer::take() {
    if (failed_.kind == TokenKind::Error || !skip_blanks()) {
        return failed_;
    }
    const Place begin = place_;
    if (at_end()) {
        return finish(TokenKind::End, begin);
    }
    const char c = text_[place_.at];
    if (const TokenKind sign = kLoneSigns.of(c); sign != TokenKind::End) {
        ++place_.at;
        return finish(sign, begin);
    }
    if (is_digit(c) || c == '.') {
        if (Token token; is_digit(c) && short_number(begin, token)) {
            return token;
        }
        const std::size_t as_number = number_length();
        if (as_number > 0 && as_number >= word_length()) {  // The longer one counts: `2d` is a name.
            return number(begin, as_number);
        }
    }
    if (is_word(c) || c == '$') {
        if (const std::size_t length = word_length(); length > 0) {
            return word(begin, length);
        }
    }
    return c == '"' ? string(begin) : punctuation(begin);
}

std::size_t Lexer::word_length() const {
    const char* const begin = text_.data() + place_.at;
    const char* const end = text_.data() + text_.size();
    const char* const first = begin != end && *begin == '$' ? begin + 1 : begin;
    const char* const at = end_of_word(first, end);
    return at > first ? static_cast<std::size_t>(at - begin) : 0;
}

bool Lexer::angle_bracket_follows(std::size_t keyword_length) const {
    std::size_t i = place_.at + keyword_length;
    while (i < text_.size() && (text_[i] == ' ' || text_[i] == '\t' || text_[i] == '\n' || text_[i] == '\r')) {
        ++i;
    }
    return i < text_.size() && text_[i] == '<';
}

Token Lexer::word(const Place& begin, std::size_t length) {
    const std::string_view text = text_.substr(place_.at, length);
    const bool includes = text == "include";
    if ((includes || text == "use") && angle_bracket_follows(length)) {
        return file_name(includes ? TokenKind::Include : TokenKind::Use, begin);
    }
    const bool digit = is_digit(text[0]);
    if (digit && text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X') &&
        text.find_first_not_of("0123456789abcdefABCDEF", 2) == std::string_view::npos) {
        return hexadecimal(begin, length);
    }
    place_.at += length;
    Token token = finish(word_kind(text, text_.data() + text_.size()), begin);
    token.name = symbols_.intern(text);
    if (digit) {
        report(sink_, {Severity::Deprecated, token.where,
                       fmt::format("Names that begin with a digit ('{}') will not be accepted in future", text), true});
    }
    return token;
}

Token Lexer::file_name(TokenKind kind, const Place& begin) {
    const bool includes = kind == TokenKind::Include;
    while (peek() != '<') {
        advance();
    }
    const Place bracket = place_;
    advance();
    // A name over several lines: what stands on the last line that is not empty counts.
    std::string name;
    std::string piece;
    std::vector<SourceRange> breaks;
    while (!at_end() && peek() != '>') {
        if (peek() != '\n' && peek() != '\r') {
            piece += text_[place_.at++];
            continue;
        }
        advance();
        breaks.push_back({file_, place_.line, column(), place_.line, column() + 1});
        name = piece.empty() ? name : piece;
        piece.clear();
    }
    if (at_end()) {
        place_ = bracket;
        ++place_.at;
        return error(bracket, fmt::format("expected '>' to close the '<' of this {}, found the end of the file",
                                          includes ? "include" : "use"));
    }
    if (!includes && !breaks.empty()) {
        warn({file_, place_.line, column(), place_.line, column() + 1},
             "new lines 'use<>'-statement is not defined - behavior may change in the future");
    }
    for (std::size_t i = 0; includes && i < breaks.size(); ++i) {
        warn(breaks[i], "new lines in 'include<>'-statement is not defined - behavior may change in the future");
    }
    advance();
    Token token = finish(kind, begin);
    token.where.line = token.where.end_line;  // The line of the `>`, as in OpenSCAD.
    if (token.where.line != begin.line) {
        token.where.column = 1;
    }
    token.name = symbols_.intern(piece.empty() ? name : piece);
    return token;
}

Token Lexer::punctuation(const Place& begin) {
    if (const TokenKind kind = sign_of_two(peek(), peek(1)); kind != TokenKind::End) {
        place_.at += 2;
        return finish(kind, begin);
    }
    if (const TokenKind kind = sign_of_one(peek()); kind != TokenKind::End) {
        ++place_.at;
        return finish(kind, begin);
    }
    std::string text = fmt::format("unexpected character {}", character_name());
    place_.at += code_point_bytes(text_, place_.at);
    return error(begin, std::move(text));
}

/// The character here, for people: "'@'", "U+201C “", "byte 0x01".
std::string Lexer::character_name() const {
    const char c = peek();
    if (c > ' ' && c <= '~') {
        return fmt::format("'{}'", c);
    }
    const std::size_t bytes = code_point_bytes(text_, place_.at);
    if (bytes > 1) {
        return fmt::format("U+{:04X} {}", static_cast<std::uint32_t>(decode_code_point(text_, place_.at)),
                           text_.substr(place_.at, bytes));
    }
    return fmt::format("byte 0x{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
}

}  // namespace csg::scad
