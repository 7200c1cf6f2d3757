// Tokens, straight from the text. A string's text ends with a zero, which is none of them.
#include "csg/scad/syntax/preparser.h"

#include <cstring>

namespace csg::scad {
namespace {

constexpr CharacterSet kPlainEscapes("\\\"tnr");

std::size_t digits(const char* at) {
    const char* const begin = at;
    while (is_digit(*at)) {
        ++at;
    }
    return static_cast<std::size_t>(at - begin);
}

}  // namespace

Preparser::Preparser(const std::string& text, SymbolTable& symbols, LazyBodies& notes)
    : text_(text), text_end_(text.data() + text.size()), symbols_(symbols), notes_(notes) {}

void Preparser::start(std::size_t begin) {
    at_ = text_.data() + begin;
    depth_ = 0;
    assigned_.clear();
}

/// A comment without end, and blanks that are not ASCII, stay: nothing accepts them.
void Preparser::skip_more_blanks() {
    for (;;) {
        switch (*at_) {
            case ' ':
                at_ = end_of_spaces(at_ + 1, text_end_);
                break;
            case '\n':
            case '\t':
            case '\r':
            case '\f':
            case '\v':
                ++at_;
                break;
            case '/':
                if (at_[1] == '/') {
                    for (at_ = end_of_line(at_, text_end_); *at_ == '\r' && at_[1] != '\n';) {
                        at_ = end_of_line(at_ + 1, text_end_);
                    }
                    break;
                }
                if (at_[1] == '*') {
                    const std::size_t close = text_.find("*/", static_cast<std::size_t>(at_ + 2 - text_.data()));
                    if (close == std::string::npos) {
                        return;
                    }
                    at_ = text_.data() + close + 2;
                    break;
                }
                return;
            default:
                return;
        }
    }
}

TokenKind Preparser::word() {
    const char* const begin = at_;
    at_ = end_of_word(at_ + 1, text_end_);
    word_ = std::string_view(begin, static_cast<std::size_t>(at_ - begin));
    ++notes_.most.names;
    skip_blanks();
    if (*begin == '$') {
        if (word_.size() == 1) {
            return TokenKind::Error;
        }
        symbols_.intern(word_);
        return TokenKind::Identifier;
    }
    const TokenKind kind = word_kind(word_, text_end_);
    const bool names_file = kind == TokenKind::Identifier && *at_ == '<' && (word_ == "include" || word_ == "use");
    return names_file ? TokenKind::Error : kind;
}

bool Preparser::accept_word(std::string_view expected) {
    const char* const end = at_ + expected.size();
    if (*at_ != expected[0] || std::strncmp(at_, expected.data(), expected.size()) != 0 || is_word(*end)) {
        return false;
    }
    ++notes_.most.names;
    skip(expected.size());
    return true;
}

/// Only numbers that a double holds whatever their digits are.
bool Preparser::number() {
    constexpr std::size_t kFewDigits = 15;
    constexpr std::size_t kShortExponent = 2;
    const char* const begin = at_;
    at_ += digits(at_);
    if (*at_ == '.') {
        at_ += 1 + digits(at_ + 1);
    }
    if (static_cast<std::size_t>(at_ - begin) > kFewDigits) {
        return false;
    }
    if (*at_ == 'e' || *at_ == 'E') {
        const char* const exponent = at_ + 1 + (at_[1] == '+' || at_[1] == '-' ? 1 : 0);
        const std::size_t count = digits(exponent);
        if (count == 0 || count > kShortExponent) {
            return false;
        }
        at_ = exponent + count;
    }
    if (is_word(*at_)) {  // A name that begins with a digit.
        return false;
    }
    skip_blanks();
    return true;
}

bool Preparser::string() {
    for (++at_; *at_ != '"'; ++at_) {
        if (*at_ == '\0' || (*at_ == '\\' && !kPlainEscapes.has(*++at_))) {
            return false;
        }
    }
    ++notes_.most.names;
    skip(1);
    return true;
}

}  // namespace csg::scad
