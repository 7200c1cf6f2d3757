// Statements: the same steps as in parser_statements.cpp.
#include <algorithm>

#include "csg/scad/syntax/preparser.h"

namespace csg::scad {

std::size_t Preparser::module_body(std::size_t begin) {
    start(begin);
    ++notes_.most.blocks;
    // What follows the last token of the body is not looked at: the parser has its say on that.
    return statement(Level::Module, 0) ? static_cast<std::size_t>(end_ - text_.data()) : 0;
}

bool Preparser::statement(Level level, std::size_t block) {
    switch (*at_) {
        case ';':
            end_ = at_ + 1;
            skip(1);
            return true;
        case '{':
            return braces(level == Level::Child ? Level::Children : level, block);
        case '!':
        case '#':
        case '%':
        case '*':
            return modified_instantiation();
        default:
            break;
    }
    if (!at_word()) {
        return false;
    }
    switch (const TokenKind kind = word(); kind) {
        case TokenKind::Module:
            return level == Level::Module && module_definition();
        case TokenKind::Function:
            return level == Level::Module && function_definition();
        case TokenKind::Identifier:
            return at_assign() ? level != Level::Child && assignment(block) : instantiation(kind);
        default:
            return instantiation(kind);
    }
}

/// Statements in braces, into the block around them.
bool Preparser::braces(Level level, std::size_t block) {
    const Nesting nesting(*this);
    if (nesting.too_deep()) {
        return false;
    }
    skip(1);
    while (*at_ != '}') {
        if (!statement(level, block)) {
            return false;
        }
    }
    end_ = at_ + 1;
    skip(1);
    return true;
}

bool Preparser::end_statement() {
    end_ = at_ + 1;
    return accept(';');
}

/// The name has been taken. One that the block has assigned before may be worth a warning.
bool Preparser::assignment(std::size_t block) {
    const std::uint64_t name = SymbolTable::hash_of(word_);
    if (std::find(assigned_.begin() + static_cast<std::ptrdiff_t>(block), assigned_.end(), name) != assigned_.end()) {
        return false;
    }
    assigned_.push_back(name);
    ++notes_.most.assignments;
    skip(1);
    return value() && end_statement();
}

bool Preparser::function_definition() {
    ++notes_.most.functions;
    if (!at_word() || word() != TokenKind::Identifier || !parameters() || !at_assign()) {
        return false;
    }
    skip(1);
    return value() && end_statement();
}

bool Preparser::module_definition() {
    const Nesting nesting(*this);
    ++notes_.most.modules;
    ++notes_.most.blocks;
    if (nesting.too_deep() || !at_word() || word() != TokenKind::Identifier || !parameters()) {
        return false;
    }
    const std::size_t block = assigned_.size();
    const bool good = statement(Level::Module, block);
    assigned_.resize(block);
    return good;
}

bool Preparser::modified_instantiation() {
    while (at_not() || *at_ == '#' || *at_ == '%' || *at_ == '*') {
        skip(1);
    }
    return at_word() && instantiation(word());
}

/// The name, or `if`, has been taken.
bool Preparser::instantiation(TokenKind name) {
    const Nesting nesting(*this);
    if (nesting.too_deep()) {
        return false;
    }
    ++notes_.most.instantiations;
    switch (name) {
        case TokenKind::If:
            return if_chain();
        case TokenKind::Identifier:
            return *at_ == '(' && call_arguments(symbols_.intern(word_)) && children();
        case TokenKind::For:
        case TokenKind::Let:
        case TokenKind::Assert:
        case TokenKind::Echo:
        case TokenKind::Each:
            return call_arguments() && children();
        default:
            return false;
    }
}

bool Preparser::if_chain() {
    for (;;) {
        ++notes_.most.arguments;
        if (!accept('(') || !value() || !accept(')') || !children()) {
            return false;
        }
        if (!accept_word("else")) {
            // One may come from a file that is included here, or stand where the including file goes on.
            return *at_ != '\0' && !accept_word("include");
        }
        if (!accept_word("if")) {
            return children();
        }
        ++notes_.most.instantiations;
        ++notes_.most.blocks;  // Of the `else`, which holds but the `if`.
    }
}

bool Preparser::children() {
    ++notes_.most.blocks;
    if (*at_ == ';') {
        return end_statement();
    }
    const std::size_t block = assigned_.size();
    const bool good = statement(Level::Child, block);
    assigned_.resize(block);
    return good;
}

}  // namespace csg::scad
