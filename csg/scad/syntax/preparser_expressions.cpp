// Expressions: the same steps as in parser_expressions.cpp and parser_lists.cpp, where precedence does not matter.
#include "csg/scad/syntax/preparser.h"

namespace csg::scad {

std::size_t Preparser::function_body(std::size_t begin) {
    start(begin);
    return value() && *at_ == ';' ? static_cast<std::size_t>(at_ - text_.data()) + 1 : 0;
}

Preparser::Outcome Preparser::expression(Position position, TokenKind first) {
    const Nesting nesting(*this);
    if (nesting.too_deep()) {
        return Outcome::Refused;
    }
    for (;;) {
        const Outcome last = unconditional(position, first);
        if (last != Outcome::Value || *at_ != '?') {
            return last;
        }
        skip(1);
        ++notes_.most.expressions;
        if (!value() || !accept(':')) {
            return Outcome::Refused;
        }
        position = Position::Plain;
        first = TokenKind::End;
    }
}

Preparser::Outcome Preparser::unconditional(Position position, TokenKind first) {
    if (first == TokenKind::End && at_word()) {
        first = word();
    }
    notes_.most.expressions += first != TokenKind::End;
    const bool element = position == Position::Element;
    const auto outcome = [](bool good) { return good ? Outcome::Value : Outcome::Refused; };
    switch (first) {
        case TokenKind::End:
            return operation(position, false);
        case TokenKind::Identifier:
        case TokenKind::True:
        case TokenKind::False:
        case TokenKind::Undef:
            return operation(position, true);
        case TokenKind::Function:
            return outcome(parameters() && value());
        case TokenKind::Let:
            return call_arguments() ? expression(position) : Outcome::Refused;
        case TokenKind::Assert:
        case TokenKind::Echo:
            return outcome(assert_or_echo());
        case TokenKind::For:
            return element ? list_for() : Outcome::Refused;
        case TokenKind::If:
            return element ? list_if() : Outcome::Refused;
        case TokenKind::Each:
            return element && expression(Position::Element) != Outcome::Refused ? Outcome::Element : Outcome::Refused;
        default:
            return Outcome::Refused;
    }
}

/// Operands with operators between them; the first may have been taken before.
Preparser::Outcome Preparser::operation(Position position, bool has_operand) {
    for (int chain = 0;;) {
        if (!has_operand) {
            if (const Outcome outcome = operand(position, chain); outcome != Outcome::Value) {
                return outcome;
            }
        }
        const After after = after_operand();
        if (after != After::Operator && after != After::Power) {
            return after == After::Nothing ? Outcome::Value : Outcome::Refused;
        }
        has_operand = false;
        position = Position::Plain;
        chain = after == After::Power ? chain + 1 : 0;
    }
}

/// With the signs before it, but without what is called, indexed or asked of it.
Preparser::Outcome Preparser::operand(Position position, int& chain) {
    for (; *at_ == '-' || *at_ == '+' || *at_ == '~' || at_not(); skip(1)) {
        ++chain;
        ++notes_.most.expressions;
        position = Position::Plain;
    }
    if (chain > kMaxChain) {
        return Outcome::Refused;
    }
    ++notes_.most.expressions;
    const auto outcome = [](bool good) { return good ? Outcome::Value : Outcome::Refused; };
    if (at_word()) {
        const TokenKind kind = word();
        return outcome(kind == TokenKind::Identifier || kind == TokenKind::True || kind == TokenKind::False ||
                       kind == TokenKind::Undef);
    }
    if (at_number()) {
        return outcome(number());
    }
    switch (*at_) {
        case '"':
            return outcome(string());
        case '[':
            return outcome(vector_or_range());
        case '(': {
            skip(1);
            const Outcome inner = expression(position);
            return accept(')') ? inner : Outcome::Refused;
        }
        default:
            return Outcome::Refused;
    }
}

/// What is called, indexed or asked of an operand, and then an operator if there is one.
Preparser::After Preparser::after_operand() {
    for (;; ++notes_.most.expressions) {
        const char next = *at_ == '\0' ? '\0' : at_[1];
        std::size_t bytes = 1;
        switch (*at_) {
            case '(':
                if (!call_arguments()) {
                    return After::Refused;
                }
                continue;
            case '[':
                skip(1);
                if (!value() || !accept(']')) {
                    return After::Refused;
                }
                continue;
            case '.':
                skip(1);
                if (!at_word() || word() != TokenKind::Identifier) {
                    return After::Refused;
                }
                continue;
            case '<':
            case '>':
                bytes = next == '=' || next == *at_ ? 2 : 1;
                break;
            case '&':
            case '|':
                bytes = next == *at_ ? 2 : 1;
                break;
            case '=':
            case '!':
                if (next != '=') {
                    return After::Nothing;
                }
                bytes = 2;
                break;
            case '^':
            case '+':
            case '-':
            case '*':
            case '/':
            case '%':
                break;
            default:
                return After::Nothing;
        }
        const bool power = *at_ == '^';
        skip(bytes);
        ++notes_.most.expressions;
        return power ? After::Power : After::Operator;
    }
}

/// With a body where what follows can begin one.
bool Preparser::assert_or_echo() {
    if (!call_arguments()) {
        return false;
    }
    if (at_word()) {
        const char* const before = at_;
        switch (const TokenKind kind = word(); kind) {
            case TokenKind::Identifier:
            case TokenKind::True:
            case TokenKind::False:
            case TokenKind::Undef:
            case TokenKind::Function:
            case TokenKind::Let:
            case TokenKind::Assert:
            case TokenKind::Echo:
                return value(kind);
            default:
                at_ = before;
                return true;
        }
    }
    const bool begins = at_number() || *at_ == '"' || *at_ == '(' || *at_ == '[' || *at_ == '+' || *at_ == '-' ||
                        *at_ == '~' || at_not();
    return !begins || value();
}

bool Preparser::vector_or_range() {
    skip(1);
    if (*at_ == ',' || *at_ == ']') {
        skip_commas();
        return accept(']');
    }
    const Outcome first = expression(Position::Element);
    if (first == Outcome::Refused) {
        return false;
    }
    ++notes_.most.elements;
    if (first == Outcome::Value && accept(':')) {
        return value() && (!accept(':') || value()) && accept(']');
    }
    while (end_item(']') && *at_ != ']') {
        if (expression(Position::Element) == Outcome::Refused) {
            return false;
        }
        ++notes_.most.elements;
    }
    return accept(']');
}

Preparser::Outcome Preparser::list_for() {
    if (!accept('(') || !arguments(kNoSymbol, true)) {
        return Outcome::Refused;
    }
    if (accept(';') && !(value() && accept(';') && arguments())) {
        return Outcome::Refused;
    }
    return accept(')') && expression(Position::Element) != Outcome::Refused ? Outcome::Element : Outcome::Refused;
}

Preparser::Outcome Preparser::list_if() {
    const bool good = accept('(') && value() && accept(')') && expression(Position::Element) != Outcome::Refused &&
                      (!accept_word("else") || expression(Position::Element) != Outcome::Refused);
    return good ? Outcome::Element : Outcome::Refused;
}

void Preparser::skip_commas() {
    while (accept(',')) {
    }
}

bool Preparser::end_item(char end, bool semicolon_ends) {
    if (*at_ != ',') {
        return *at_ == end || (semicolon_ends && *at_ == ';');
    }
    skip_commas();
    return true;
}

/// Up to the parenthesis that ends them, or the semicolon.
bool Preparser::arguments(Symbol module, bool semicolon_ends) {
    skip_commas();
    while (*at_ != ')' && !(semicolon_ends && *at_ == ';')) {
        ++notes_.most.arguments;
        TokenKind first = TokenKind::End;
        if (at_word()) {
            first = word();
            if (first == TokenKind::Identifier && at_assign()) {
                if (module != kNoSymbol && word_[0] != '$') {
                    notes_.passed.emplace_back(module, symbols_.intern(word_));
                }
                skip(1);
                first = TokenKind::End;
            }
        }
        if (!value(first) || !end_item(')', semicolon_ends)) {
            return false;
        }
    }
    return true;
}

bool Preparser::parameters() {
    if (!accept('(')) {
        return false;
    }
    skip_commas();
    while (*at_ != ')') {
        ++notes_.most.arguments;
        if (!at_word() || word() != TokenKind::Identifier) {
            return false;
        }
        if (at_assign()) {
            skip(1);
            if (!value()) {
                return false;
            }
        }
        if (!end_item(')')) {
            return false;
        }
    }
    return accept(')');
}

}  // namespace csg::scad
