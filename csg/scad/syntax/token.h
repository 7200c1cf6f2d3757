// Tokens: the words of the language.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "csg/scad/source/source.h"
#include "csg/scad/value/symbols.h"

namespace csg::scad {

enum class TokenKind : std::uint8_t {
    // Behind these nothing is read before they are taken:
    End,
    Error,  ///< name: what is wrong
    Piece,  ///< Statements that are parsed already (piece.h).
    // Other files:
    Include,  ///< name: the file, as written
    Use,      ///< name: the file, as written
    // What there is many of:
    Number,      ///< number
    String,      ///< name: the text, escapes resolved
    Identifier,  ///< name
    // Words:
    Module,
    Function,
    If,
    Else,
    For,
    Let,
    Assert,
    Echo,
    Each,
    True,
    False,
    Undef,
    // Signs:
    ParenOpen,
    ParenClose,
    BracketOpen,
    BracketClose,
    BraceOpen,
    BraceClose,
    Comma,
    Semicolon,
    Colon,
    Question,
    Dot,
    Assign,
    Not,
    Hash,
    Percent,
    Star,
    Plus,
    Minus,
    Slash,
    Caret,
    Tilde,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
    BitAnd,
    BitOr,
    ShiftLeft,
    ShiftRight
};

struct Token {
    TokenKind kind = TokenKind::End;
    Symbol name = kNoSymbol;  ///< Of words too, as `for` and `let` may name modules.
    std::uint32_t at = 0;     ///< The offset of its first byte in its file.
    double number = 0;
    SourceRange where;
};

/// A sign or word as it is written ("<=", "module"); empty for kinds that have many forms.
[[nodiscard]] std::string_view token_text(TokenKind kind);

/// The kind of a word; Identifier where it is none of the language's own.
[[nodiscard]] TokenKind word_kind(std::string_view word);

/// The same of a word of up to eight bytes: the first byte is the lowest of `word`, and behind the last are zeros.
[[nodiscard]] TokenKind word_kind(std::uint64_t word);

/// The same of a word in a text that ends at `end`: eight bytes are read at once where there are as many.
[[nodiscard]] inline TokenKind word_kind(std::string_view word, const char* end) {
    if constexpr (std::endian::native == std::endian::little) {
        if (word.size() > sizeof(std::uint64_t)) {
            return TokenKind::Identifier;
        }
        if (end - word.data() >= static_cast<std::ptrdiff_t>(sizeof(std::uint64_t))) {
            std::uint64_t bytes = 0;
            std::memcpy(&bytes, word.data(), sizeof(bytes));
            return word_kind(bytes & ~std::uint64_t{0} >> (64 - 8 * word.size()));
        }
    }
    return word_kind(word);
}

}  // namespace csg::scad
