// What the parser asks of tokens, and how it says what is wrong with them.
#include <fmt/format.h>

#include <algorithm>

#include "csg/scad/syntax/parser_impl.h"

namespace csg::scad {

Parser::Nesting::Nesting(Parser& parser) : parser_(parser) {
    if (parser_.depth_ >= kMaxNesting) {
        parser_.fail(parser_.current().where, fmt::format("nested deeper than {} levels", kMaxNesting));
    }
    ++parser_.depth_;
}

bool Parser::at_assignment() const {
    return at(TokenKind::Identifier) && tokens_->next().kind == TokenKind::Assign;
}

bool Parser::at_module_name() const {
    switch (current().kind) {
        case TokenKind::Identifier:
        case TokenKind::For:
        case TokenKind::Let:
        case TokenKind::Assert:
        case TokenKind::Echo:
        case TokenKind::Each:
            return true;
        default:
            return false;
    }
}

/// What follows the arguments of an instantiation, but a semicolon. Where none of this stands, a semicolon is missing.
bool Parser::begins_child() const {
    switch (current().kind) {
        case TokenKind::BraceOpen:
        case TokenKind::If:
        case TokenKind::Not:
        case TokenKind::Hash:
        case TokenKind::Percent:
        case TokenKind::Star:
            return true;
        default:
            return at_module_name() && !at_assignment();
    }
}

bool Parser::accept(TokenKind kind) {
    if (!at(kind)) {
        return false;
    }
    take();
    return true;
}

Token Parser::expect(TokenKind kind, std::string_view context) {
    if (!at(kind)) {
        fail_expected(fmt::format("'{}' {}", token_text(kind), context));
    }
    return take();
}

Token Parser::expect_name(std::string_view what) {
    if (!at(TokenKind::Identifier)) {
        const bool reserved = current().name != kNoSymbol && !token_text(current().kind).empty();
        fail_expected(fmt::format("{}{}", what, reserved ? " (words of the language are no names)" : ""));
    }
    return take();
}

/// A missing semicolon is missed where the statement ends, not where the next one begins.
void Parser::expect_semicolon(std::string_view after) {
    if (accept(TokenKind::Semicolon)) {
        return;
    }
    if (at(TokenKind::Error)) {
        fail_expected("");
    }
    fail(after_previous(), fmt::format("expected ';' after {}, found {}", after, found()));
}

Token Parser::close(TokenKind kind, const Token& open, std::string_view also) {
    if (!at(kind)) {
        fail_expected(fmt::format("{}'{}' to close the '{}' opened on line {}", also, token_text(kind),
                                  token_text(open.kind), open.where.line));
    }
    return take();
}

void Parser::fail(const SourceRange& where, std::string text) const {
    throw SyntaxError{where, std::move(text)};
}

void Parser::fail_expected(std::string_view expected) const {
    if (at(TokenKind::Error)) {
        fail(current().where, program_.symbols.text(current().name));
    }
    fail(current().where, fmt::format("expected {}, found {}", expected, found()));
}

/// The current token as messages show it.
std::string Parser::found() const {
    constexpr std::size_t kShown = 40;
    const Token& token = current();
    if (token.kind == TokenKind::End) {
        return "the end of the file";
    }
    if (const std::string_view text = token_text(token.kind); !text.empty()) {
        return fmt::format("'{}'", text);
    }
    if (token.kind == TokenKind::Include || token.kind == TokenKind::Use) {
        return token.kind == TokenKind::Use ? "'use'" : "'include'";
    }
    const SourceRange& where = token.where;
    std::string_view text = program_.sources[where.file].line(where.line);
    text = text.substr(std::min<std::size_t>(where.column - 1, text.size()));
    if (where.end_line == where.line) {
        text = text.substr(0, where.end_column - where.column);
    }
    const bool cut = text.size() > kShown || where.end_line != where.line;
    std::size_t length = std::min(text.size(), kShown);
    while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
        --length;
    }
    const std::string shown = fmt::format("{}{}", text.substr(0, length), cut ? "…" : "");
    return token.kind == TokenKind::String ? fmt::format("the string {}", shown) : fmt::format("'{}'", shown);
}

SourceRange Parser::after_previous() const {
    const SourceRange& last = tokens_->previous();
    if (!last.known()) {
        return current().where;
    }
    return {last.file, last.end_line, last.end_column, last.end_line, last.end_column + 1};
}

}  // namespace csg::scad
