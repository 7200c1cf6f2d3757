// Expressions but lists.
#include <fmt/format.h>

#include "csg/scad/syntax/parser_impl.h"

namespace csg::scad {
namespace {

struct BinaryOperator {
    Operator op = Operator::None;
    int precedence = 0;  ///< 0: no binary operator.
};

BinaryOperator binary_operator(TokenKind kind) {
    switch (kind) {
        case TokenKind::Or:
            return {Operator::Or, 1};
        case TokenKind::And:
            return {Operator::And, 2};
        case TokenKind::Equal:
            return {Operator::Equal, 3};
        case TokenKind::NotEqual:
            return {Operator::NotEqual, 3};
        case TokenKind::Less:
            return {Operator::Less, 4};
        case TokenKind::LessEqual:
            return {Operator::LessEqual, 4};
        case TokenKind::Greater:
            return {Operator::Greater, 4};
        case TokenKind::GreaterEqual:
            return {Operator::GreaterEqual, 4};
        case TokenKind::BitOr:
            return {Operator::BitOr, 5};
        case TokenKind::BitAnd:
            return {Operator::BitAnd, 6};
        case TokenKind::ShiftLeft:
            return {Operator::ShiftLeft, 7};
        case TokenKind::ShiftRight:
            return {Operator::ShiftRight, 7};
        case TokenKind::Plus:
            return {Operator::Add, 8};
        case TokenKind::Minus:
            return {Operator::Subtract, 8};
        case TokenKind::Star:
            return {Operator::Multiply, 9};
        case TokenKind::Slash:
            return {Operator::Divide, 9};
        case TokenKind::Percent:
            return {Operator::Modulo, 9};
        default:
            return {};
    }
}

}  // namespace

ExprId Parser::add(Expr& e) {
    if (e.kind == ExprKind::Binary || e.kind == ExprKind::Index || e.kind == ExprKind::Member) {
        const std::uint8_t left = program_[e.operand(0)].links;
        e.links = left < 255 ? static_cast<std::uint8_t>(left + 1) : left;
    }
    program_.expressions.push_back(e);
    return static_cast<ExprId>(program_.expressions.size() - 1);
}

bool Parser::is_element(ExprId e) const {
    return is_element_kind(program_[e].kind);
}

bool Parser::begins_expression() const {
    switch (current().kind) {
        case TokenKind::Number:
        case TokenKind::String:
        case TokenKind::Identifier:
        case TokenKind::True:
        case TokenKind::False:
        case TokenKind::Undef:
        case TokenKind::Function:
        case TokenKind::Let:
        case TokenKind::Assert:
        case TokenKind::Echo:
        case TokenKind::ParenOpen:
        case TokenKind::BracketOpen:
        case TokenKind::Plus:
        case TokenKind::Minus:
        case TokenKind::Not:
        case TokenKind::Tilde:
            return true;
        default:
            return false;
    }
}

ExprId Parser::expression(Position position) {
    const Nesting nesting(*this);
    struct Arm {
        ExprId condition, then;
    };
    std::vector<Arm> arms;  // Of "a ? b : c ? d : …".
    ExprId last = unconditional(position);
    while (at(TokenKind::Question) && !is_element(last)) {
        take();
        const ExprId then = expression();
        if (!at(TokenKind::Colon)) {
            fail_expected("':' to go with the '?' before it");
        }
        take();
        arms.push_back({last, then});
        last = unconditional(Position::Plain);
    }
    for (auto arm = arms.rbegin(); arm != arms.rend(); ++arm) {
        Expr e;
        e.kind = ExprKind::Conditional;
        e.operands = {arm->condition, arm->then, last};
        e.where = spanning(program_[arm->condition].where, program_[last].where);
        last = add(e);
    }
    return last;
}

ExprId Parser::unconditional(Position position) {
    const bool element = position == Position::Element;
    switch (current().kind) {
        case TokenKind::Function:
            return function_literal();
        case TokenKind::Let:
            return let(position);
        case TokenKind::Assert:
            return assert_or_echo(ExprKind::Assert);
        case TokenKind::Echo:
            return assert_or_echo(ExprKind::Echo);
        case TokenKind::For:
            return element ? list_for() : binary(position);
        case TokenKind::If:
            return element ? list_if() : binary(position);
        case TokenKind::Each:
            return element ? list_each() : binary(position);
        default:
            return binary(position);
    }
}

/// All operators group to the left, but ^ (see power). Operators that wait for a tighter one on their right are kept on
/// a stack: nine levels of precedence cost no recursion.
ExprId Parser::binary(Position position) {
    const std::size_t mark = pending_operators_.size();
    ExprId operand = unary(position);
    if (is_element(operand)) {
        return operand;
    }
    for (;;) {
        const BinaryOperator found = binary_operator(current().kind);
        while (pending_operators_.size() > mark && pending_operators_.back().precedence >= found.precedence) {
            const PendingOperator& waiting = pending_operators_.back();
            Expr e;
            e.kind = ExprKind::Binary;
            e.op = waiting.op;
            e.operands = {waiting.left, operand, kNone};
            e.where = spanning(program_[waiting.left].where, program_[operand].where);
            operand = add(e);
            pending_operators_.pop_back();
        }
        if (found.precedence == 0) {
            return operand;
        }
        take();
        pending_operators_.push_back({operand, found.op, found.precedence});
        operand = unary(Position::Plain);
    }
}

ExprId Parser::unary(Position position) {
    Operator op = Operator::None;
    switch (current().kind) {
        case TokenKind::Minus:
            op = Operator::Negate;
            break;
        case TokenKind::Plus:
            op = Operator::Plus;
            break;
        case TokenKind::Not:
            op = Operator::Not;
            break;
        case TokenKind::Tilde:
            op = Operator::BitNot;
            break;
        default:
            return power(position);
    }
    const Nesting nesting(*this);
    const Token sign = take();
    const ExprId operand = unary(Position::Plain);
    if (op == Operator::Plus) {  // Means nothing, whatever the operand is.
        return operand;
    }
    if (op == Operator::Negate && program_[operand].kind == ExprKind::Number) {
        return negated(operand, sign.where);
    }
    Expr e;
    e.kind = ExprKind::Unary;
    e.op = op;
    e.operands[0] = operand;
    e.where = spanning(sign.where, program_[operand].where);
    return add(e);
}

/// "-5" is a literal.
ExprId Parser::negated(ExprId operand, const SourceRange& sign) {
    Expr& number = program_.expressions[operand];
    number.number = -number.number;
    number.where = spanning(sign, number.where);
    return operand;
}

/// Binds tighter than a sign before it, less than one after it, and groups to the right: -a^-b^c is -(a^(-(b^c))).
ExprId Parser::power(Position position) {
    const ExprId base = postfix(position);
    if (!at(TokenKind::Caret) || is_element(base)) {
        return base;
    }
    const Nesting nesting(*this);
    take();
    const ExprId exponent = unary(Position::Plain);
    Expr e;
    e.kind = ExprKind::Binary;
    e.op = Operator::Power;
    e.operands = {base, exponent, kNone};
    e.where = spanning(program_[base].where, program_[exponent].where);
    return add(e);
}

ExprId Parser::postfix(Position position) {
    ExprId value = primary(position);
    while (!is_element(value)) {
        if (at(TokenKind::ParenOpen)) {
            value = call(value);
        } else if (at(TokenKind::BracketOpen)) {
            value = index(value);
        } else if (at(TokenKind::Dot)) {
            value = member(value);
        } else {
            break;
        }
    }
    return value;
}

ExprId Parser::call(ExprId callee) {
    Expr e;
    e.kind = ExprKind::Call;
    e.operands[0] = callee;
    e.list = call_arguments("");
    e.where = from(program_[callee].where);
    return add(e);
}

ExprId Parser::index(ExprId value) {
    const Token open = take();
    Expr e;
    e.kind = ExprKind::Index;
    e.operands = {value, expression(), kNone};
    close(TokenKind::BracketClose, open);
    e.where = from(program_[value].where);
    return add(e);
}

ExprId Parser::member(ExprId value) {
    take();
    Expr e;
    e.kind = ExprKind::Member;
    e.operands[0] = value;
    e.name = expect_name("the name of a member after '.'").name;
    e.where = from(program_[value].where);
    return add(e);
}

ExprId Parser::primary(Position position) {
    switch (current().kind) {
        case TokenKind::Number:
            return literal(ExprKind::Number, current().number);
        case TokenKind::String:
            return literal(ExprKind::String);
        case TokenKind::Identifier:
            return literal(ExprKind::Identifier);
        case TokenKind::True:
            return literal(ExprKind::Boolean, 1);
        case TokenKind::False:
            return literal(ExprKind::Boolean, 0);
        case TokenKind::Undef:
            return literal(ExprKind::Undef);
        case TokenKind::ParenOpen:
            return parenthesised(position);
        case TokenKind::BracketOpen:
            return vector_or_range();
        case TokenKind::Function:
        case TokenKind::Let:
        case TokenKind::Assert:
        case TokenKind::Echo:
            fail(current().where,
                 fmt::format("'{}' cannot be an operand: put parentheses around it", token_text(current().kind)));
        case TokenKind::For:
        case TokenKind::If:
        case TokenKind::Each:
            fail(current().where,
                 fmt::format("'{}' gives elements of a list: put brackets around it", token_text(current().kind)));
        default:
            fail_expected("an expression");
    }
}

ExprId Parser::literal(ExprKind kind, double number) {
    const Token& token = take();
    Expr e;
    e.kind = kind;
    e.name = kind == ExprKind::String || kind == ExprKind::Identifier ? token.name : kNoSymbol;
    e.number = number;
    e.where = token.where;
    return add(e);
}

ExprId Parser::parenthesised(Position position) {
    const Token open = take();
    const ExprId inner = expression(position);
    close(TokenKind::ParenClose, open);
    return inner;
}

ExprId Parser::function_literal() {
    const Token word = take();
    Expr e;
    e.kind = ExprKind::Function;
    e.list = parameters("after 'function'");
    e.operands[0] = expression();
    e.where = from(word.where);
    return add(e);
}

ExprId Parser::let(Position position) {
    const Token word = take();
    Expr e;
    e.list = call_arguments("after 'let'");
    e.operands[0] = expression(position);
    e.kind = is_element(e.operands[0]) ? ExprKind::ListLet : ExprKind::Let;
    e.where = from(word.where);
    return add(e);
}

ExprId Parser::assert_or_echo(ExprKind kind) {
    const Token word = take();
    Expr e;
    e.kind = kind;
    e.list = call_arguments(kind == ExprKind::Assert ? "after 'assert'" : "after 'echo'");
    if (begins_expression()) {
        e.operands[0] = expression();
    }
    e.where = from(word.where);
    return add(e);
}

}  // namespace csg::scad
