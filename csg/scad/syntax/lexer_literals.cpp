// Numbers and strings.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "csg/scad/source/characters.h"
#include "csg/scad/syntax/lexer.h"
#include "csg/scad/value/value.h"

namespace csg::scad {
namespace {

int hexadecimal_digit(char c) {
    return is_digit(c) ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// True for 0.00…01 and 1e-999: too close to zero, not too far from it. `text` is a number out of a double's range.
bool is_tiny(std::string_view text) {
    const std::size_t e = text.find_first_of("eE");
    const std::string_view digits = text.substr(0, e);
    long exponent = 0;
    if (e != std::string_view::npos) {
        std::string_view written = text.substr(e + 1);
        const bool negative = written.front() == '-';
        written.remove_prefix(negative || written.front() == '+' ? 1 : 0);
        const auto parsed = std::from_chars(written.data(), written.data() + written.size(), exponent);
        if (parsed.ec != std::errc()) {
            return negative;
        }
        exponent = negative ? -exponent : exponent;
    }
    const std::size_t first = digits.find_first_not_of("0.");
    const std::size_t dot = std::min(digits.find('.'), digits.size());
    if (first == std::string_view::npos) {
        return true;
    }
    return exponent + static_cast<long>(dot) - static_cast<long>(first) < 0;
}

/// False where it is more than 64 bits hold.
bool read_integer(std::string_view text, int base, std::uint64_t& value) {
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value, base);
    return result.ec == std::errc();
}

bool exact(std::uint64_t integer) {
    const auto number = static_cast<double>(integer);
    return number < 0x1p64 && static_cast<std::uint64_t>(number) == integer;
}

}  // namespace

/// Of `12`, `1.`, `.5`, `1e3`; 0 where none begins here.
std::size_t Lexer::number_length() const {
    std::size_t length = 0;
    while (is_digit(peek(length))) {
        ++length;
    }
    std::size_t digits = length;
    if (peek(length) == '.') {
        std::size_t end = length + 1;
        while (is_digit(peek(end))) {
            ++end;
        }
        digits += end - length - 1;
        length = digits > 0 ? end : length;
    }
    if (digits > 0 && (peek(length) == 'e' || peek(length) == 'E')) {
        std::size_t end = length + 1;
        end += peek(end) == '+' || peek(end) == '-' ? 1 : 0;
        if (is_digit(peek(end))) {
            while (is_digit(peek(end))) {
                ++end;
            }
            length = end;
        }
    }
    return digits > 0 ? length : 0;
}

/// Of at most fifteen digits, without an exponent: these, and the powers of ten that they are divided by, are numbers
/// that a double holds, so the quotient is the double that is nearest to what is written.
bool Lexer::short_number(const Place& begin, Token& token) {
    static constexpr std::array<double, 16> kPowers = {1,   1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                       1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const char* const first = text_.data() + place_.at;
    const char* at = first;
    std::uint64_t digits = 0;
    const auto read_digits = [&] {
        const char* const start = at;
        for (; is_digit(*at); ++at) {
            digits = digits * 10 + static_cast<std::uint64_t>(*at - '0');
        }
        return static_cast<std::size_t>(at - start);
    };
    const std::size_t before = read_digits();
    std::size_t behind = 0;
    if (*at == '.') {
        ++at;
        behind = read_digits();
    }
    if (before + behind >= kPowers.size() || is_word(*at)) {
        return false;
    }
    place_.at += static_cast<std::size_t>(at - first);
    token = finish(TokenKind::Number, begin);
    token.number = static_cast<double>(digits) / kPowers[behind];
    return true;
}

Token Lexer::number(const Place& begin, std::size_t length) {
    const std::string_view text = text_.substr(place_.at, length);
    place_.at += length;
    Token token = finish(TokenKind::Number, begin);
    const auto result = std::from_chars(text.data(), text.data() + text.size(), token.number);
    if (result.ec == std::errc::result_out_of_range) {
        token.number = is_tiny(text) ? 0.0 : std::numeric_limits<double>::infinity();
        if (token.number != 0) {
            warn(token.where, fmt::format("Number \"{}\" too large", text.substr(0, 40)));
        }
        return token;
    }
    constexpr std::size_t kAlwaysExact = 15;  // So many digits.
    std::uint64_t integer = 0;
    if (text.size() > kAlwaysExact && text.find_first_of(".eE") == std::string_view::npos &&
        read_integer(text, 10, integer) && !exact(integer)) {
        warn(token.where, fmt::format("Integer \"{}\" cannot be represented precisely", text));
    }
    return token;
}

Token Lexer::hexadecimal(const Place& begin, std::size_t length) {
    const std::string_view text = text_.substr(place_.at, length);
    place_.at += length;
    Token token = finish(TokenKind::Number, begin);
    std::uint64_t integer = 0;
    if (!read_integer(text.substr(2), 16, integer)) {
        integer = std::numeric_limits<std::uint64_t>::max();
        warn(token.where, fmt::format("Hexadecimal constant \"{}\" too large", text.substr(0, 40)));
    } else if (!exact(integer)) {
        warn(token.where, fmt::format("Integer \"{}\" cannot be represented precisely", text));
    }
    token.number = static_cast<double>(integer);
    return token;
}

Token Lexer::string(const Place& begin) {
    ++place_.at;
    const std::string_view rest = text_.substr(place_.at);
    const std::size_t plain = std::min(rest.find_first_of("\"\\\r\n"), rest.size());
    std::string value(rest.substr(0, plain));  // Up to the quote, mostly.
    place_.at += plain;
    while (!at_end() && peek() != '"') {
        if (peek() == '\\') {
            escape(value);
        } else {
            const char c = peek();
            advance();
            if (c != '\n' && c != '\r') {  // Line ends fall away, as in OpenSCAD.
                value += c;
            }
        }
    }
    if (at_end()) {
        place_ = begin;
        ++place_.at;
        return error(begin, "unterminated string: expected '\"' before the end of the file");
    }
    ++place_.at;
    Token token = finish(TokenKind::String, begin);
    token.name = symbols_.intern(value);
    return token;
}

/// `digits` of them, after a backslash and a letter; kNoCodePoint where there are fewer.
constexpr char32_t kNoCodePoint = 0xFFFFFFFF;

char32_t Lexer::hexadecimal_escape(std::size_t digits) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < digits; ++i) {
        const int digit = hexadecimal_digit(peek(2 + i));
        if (digit < 0) {
            return kNoCodePoint;
        }
        value = value * 16 + static_cast<std::uint32_t>(digit);
    }
    return value;
}

void Lexer::escape(std::string& out) {
    const Place begin = place_;
    const char letter = peek(1);
    std::size_t length = 2;
    switch (letter) {
        case '\\':
        case '"':
            out += letter;
            break;
        case 't':
            out += '\t';
            break;
        case 'n':
            out += '\n';
            break;
        case 'r':
            out += '\r';
            break;
        default: {
            const std::size_t digits = letter == 'x' ? 2 : letter == 'u' ? 4 : letter == 'U' ? 6 : 0;
            char32_t code_point = digits == 0 ? kNoCodePoint : hexadecimal_escape(digits);
            if (code_point == kNoCodePoint || (letter == 'x' && code_point > 0x7F)) {
                ++place_.at;  // The backslash falls away; what follows is ordinary text.
                warn({file_, begin.line, static_cast<std::uint32_t>(begin.at - begin.line_start) + 1, begin.line,
                      column() + (at_end() ? 0 : 1)},
                     "Undefined escape sequence");
                return;
            }
            // No text holds U+0000, a half of a surrogate pair or what is beyond Unicode: a space in their place.
            const bool valid =
                code_point != 0 && code_point <= 0x10FFFF && (code_point < 0xD800 || code_point > 0xDFFF);
            append_utf8(out, valid ? code_point : U' ');
            length += digits;
        }
    }
    place_.at += length;
}

}  // namespace csg::scad
