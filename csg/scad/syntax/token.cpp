#include "csg/scad/syntax/token.h"

#include <algorithm>
#include <array>
#include <utility>

namespace csg::scad {
namespace {

using Row = std::pair<TokenKind, std::string_view>;

constexpr std::array<Row, 12> kWords{{{TokenKind::Module, "module"},
                                      {TokenKind::Function, "function"},
                                      {TokenKind::If, "if"},
                                      {TokenKind::Else, "else"},
                                      {TokenKind::For, "for"},
                                      {TokenKind::Let, "let"},
                                      {TokenKind::Assert, "assert"},
                                      {TokenKind::Echo, "echo"},
                                      {TokenKind::Each, "each"},
                                      {TokenKind::True, "true"},
                                      {TokenKind::False, "false"},
                                      {TokenKind::Undef, "undef"}}};

constexpr std::array<Row, 33> kSigns{
    {{TokenKind::ParenOpen, "("},     {TokenKind::ParenClose, ")"}, {TokenKind::BracketOpen, "["},
     {TokenKind::BracketClose, "]"},  {TokenKind::BraceOpen, "{"},  {TokenKind::BraceClose, "}"},
     {TokenKind::Comma, ","},         {TokenKind::Semicolon, ";"},  {TokenKind::Colon, ":"},
     {TokenKind::Question, "?"},      {TokenKind::Dot, "."},        {TokenKind::Assign, "="},
     {TokenKind::Not, "!"},           {TokenKind::Hash, "#"},       {TokenKind::Percent, "%"},
     {TokenKind::Star, "*"},          {TokenKind::Plus, "+"},       {TokenKind::Minus, "-"},
     {TokenKind::Slash, "/"},         {TokenKind::Caret, "^"},      {TokenKind::Tilde, "~"},
     {TokenKind::Less, "<"},          {TokenKind::LessEqual, "<="}, {TokenKind::Greater, ">"},
     {TokenKind::GreaterEqual, ">="}, {TokenKind::Equal, "=="},     {TokenKind::NotEqual, "!="},
     {TokenKind::And, "&&"},          {TokenKind::Or, "||"},        {TokenKind::BitAnd, "&"},
     {TokenKind::BitOr, "|"},         {TokenKind::ShiftLeft, "<<"}, {TokenKind::ShiftRight, ">>"}}};

constexpr std::uint64_t packed(std::string_view word) {
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < word.size(); ++i) {
        bytes |= std::uint64_t{static_cast<unsigned char>(word[i])} << 8 * i;
    }
    return bytes;
}

/// The words by a hash that has a place for each.
struct WordTable {
    static constexpr std::size_t kSize = 64;
    std::array<std::uint64_t, kSize> words{};
    std::array<TokenKind, kSize> kinds{};
    std::uint64_t multiplier = 0x9e3779b97f4a7c15U;

    [[nodiscard]] constexpr std::size_t place(std::uint64_t word) const { return word * multiplier >> 58; }
    constexpr WordTable() {
        while (!fill()) {
            multiplier += 2;
        }
    }

  private:
    constexpr bool fill() {
        words.fill(0);
        kinds.fill(TokenKind::Identifier);
        for (const Row& row : kWords) {
            const std::uint64_t word = packed(row.second);
            const std::size_t at = place(word);
            if (words[at] != 0) {
                return false;
            }
            words[at] = word;
            kinds[at] = row.first;
        }
        return true;
    }
};

constexpr WordTable kWordTable;

}  // namespace

std::string_view token_text(TokenKind kind) {
    const auto is_kind = [&](const Row& row) { return row.first == kind; };
    if (const auto* const sign = std::find_if(kSigns.begin(), kSigns.end(), is_kind); sign != kSigns.end()) {
        return sign->second;
    }
    const auto* const word = std::find_if(kWords.begin(), kWords.end(), is_kind);
    return word == kWords.end() ? std::string_view() : word->second;
}

TokenKind word_kind(std::string_view word) {
    // By the first letter: most words are names, and are told from these few by it.
    const auto is = [&](std::string_view text, TokenKind kind, TokenKind otherwise = TokenKind::Identifier) {
        return word == text ? kind : otherwise;
    };
    switch (word.empty() ? '\0' : word[0]) {
        case 'a':
            return is("assert", TokenKind::Assert);
        case 'e':
            return is("else", TokenKind::Else, is("each", TokenKind::Each, is("echo", TokenKind::Echo)));
        case 'f':
            return is("for", TokenKind::For, is("false", TokenKind::False, is("function", TokenKind::Function)));
        case 'i':
            return is("if", TokenKind::If);
        case 'l':
            return is("let", TokenKind::Let);
        case 'm':
            return is("module", TokenKind::Module);
        case 't':
            return is("true", TokenKind::True);
        case 'u':
            return is("undef", TokenKind::Undef);
        default:
            return TokenKind::Identifier;
    }
}

TokenKind word_kind(std::uint64_t word) {
    const std::size_t at = kWordTable.place(word);
    return kWordTable.words[at] == word ? kWordTable.kinds[at] : TokenKind::Identifier;
}

}  // namespace csg::scad
