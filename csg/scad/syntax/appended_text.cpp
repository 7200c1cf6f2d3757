#include "csg/scad/syntax/appended_text.h"

#include <algorithm>

#include "csg/scad/syntax/lexer.h"

namespace csg::scad {
namespace {

/// Every statement begins as an assignment does. An odd token is for the parser to tell of.
bool is_assignments(const std::string& text) {
    SymbolTable symbols;
    const MessageSink nobody;
    Lexer lexer(text, 0, symbols, nobody);
    int depth = 0;
    bool at_start = true;
    for (Token token = lexer.take(); token.kind != TokenKind::End && token.kind != TokenKind::Error;) {
        const Token next = lexer.take();
        if (at_start && !(token.kind == TokenKind::Identifier && next.kind == TokenKind::Assign)) {
            return token.kind == TokenKind::Assign || next.kind == TokenKind::End;
        }
        at_start = false;
        switch (token.kind) {
            case TokenKind::ParenOpen:
            case TokenKind::BracketOpen:
            case TokenKind::BraceOpen:
                ++depth;
                break;
            case TokenKind::ParenClose:
            case TokenKind::BracketClose:
            case TokenKind::BraceClose:
                --depth;
                break;
            case TokenKind::Semicolon:
                at_start = depth == 0;
                break;
            default:
                break;
        }
        token = next;
    }
    return true;
}

}  // namespace

bool has_statements(std::span<const std::string> definitions) {
    return std::any_of(definitions.begin(), definitions.end(),
                       [](const std::string& text) { return !is_assignments(text); });
}

void append_statements(std::string& text, std::vector<std::string>& definitions) {
    if (!has_statements(definitions)) {
        return;
    }
    for (const std::string& definition : definitions) {
        text += '\n' + definition + ';';
    }
    text += '\n';
    definitions.clear();
}

}  // namespace csg::scad
