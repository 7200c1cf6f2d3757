// Vectors, ranges, list comprehensions, and lists of arguments and parameters.
#include <fmt/format.h>

#include "csg/scad/parser_impl.h"

namespace csg::scad {

ExprId Parser::vector_or_range() {
    const Token open = take();
    while (accept(TokenKind::Comma)) {  // OpenSCAD allows any number of commas here, before and after.
    }
    if (at(TokenKind::BracketClose)) {
        return vector(open, kNone);
    }
    const ExprId first = expression(Position::Element);
    return at(TokenKind::Colon) && !is_element(first) ? range(open, first) : vector(open, first);
}

ExprId Parser::range(const Token& open, ExprId begin) {
    take();
    Expr e;
    e.kind = ExprKind::Range;
    e.operands = {begin, kNone, expression()};
    if (accept(TokenKind::Colon)) {
        e.operands[1] = e.operands[2];
        e.operands[2] = expression();
    }
    close(TokenKind::BracketClose, open);
    e.where = from(open.where);
    return add(e);
}

ExprId Parser::vector(const Token& open, ExprId first) {
    const std::size_t mark = pending_elements_.size();
    if (first != kNone) {
        pending_elements_.push_back(first);
    }
    while (!at(TokenKind::BracketClose)) {
        if (!accept(TokenKind::Comma)) {
            close(TokenKind::BracketClose, open, "',' or ");
        }
        while (accept(TokenKind::Comma)) {
        }
        if (!at(TokenKind::BracketClose)) {
            pending_elements_.push_back(expression(Position::Element));
        }
    }
    take();
    Expr e;
    e.kind = ExprKind::Vector;
    e.list = append_run(program_.elements, pending_elements_, mark);
    e.where = from(open.where);
    return add(e);
}

ExprId Parser::list_for() {
    const Token word = take();
    const Token open = expect(TokenKind::ParenOpen, "after 'for'");
    Expr e;
    e.kind = ExprKind::ListFor;
    e.list = arguments(TokenKind::ParenClose, open);
    if (accept(TokenKind::Semicolon)) {
        e.kind = ExprKind::ListForC;
        e.operands[1] = expression();
        expect(TokenKind::Semicolon, "after the condition of this 'for'");
        e.update = arguments(TokenKind::ParenClose, open);
    }
    close(TokenKind::ParenClose, open, "',' or ");
    e.operands[0] = expression(Position::Element);
    e.where = from(word.where);
    return add(e);
}

ExprId Parser::list_if() {
    const Token word = take();
    const Token open = expect(TokenKind::ParenOpen, "after 'if'");
    Expr e;
    e.kind = ExprKind::ListIf;
    e.operands[0] = expression();
    close(TokenKind::ParenClose, open);
    e.operands[1] = expression(Position::Element);
    if (accept(TokenKind::Else)) {
        e.operands[2] = expression(Position::Element);
    }
    e.where = from(word.where);
    return add(e);
}

ExprId Parser::list_each() {
    const Token word = take();
    Expr e;
    e.kind = ExprKind::ListEach;
    e.operands[0] = expression(Position::Element);
    e.where = from(word.where);
    return add(e);
}

/// Pending arguments from `mark` on become a run of the program's.
Run Parser::gather(std::size_t mark) {
    return append_run(program_.arguments, pending_arguments_, mark);
}

Run Parser::arguments(TokenKind end, const Token& open) {
    const std::size_t mark = pending_arguments_.size();
    while (!at(end) && !at(TokenKind::Semicolon)) {
        if (pending_arguments_.size() > mark && !accept(TokenKind::Comma)) {
            close(end, open, "',' or ");
        }
        if (pending_arguments_.size() > mark && at(end)) {
            break;  // After a comma at the end.
        }
        Argument a;
        const SourceRange first = current().where;
        if (at_assignment()) {
            a.name = take().name;
            take();
        }
        a.value = expression();
        a.where = spanning(first, program_[a.value].where);
        pending_arguments_.push_back(a);
    }
    return gather(mark);
}

Run Parser::call_arguments(std::string_view after) {
    const Token open = expect(TokenKind::ParenOpen, after);
    const Run run = arguments(TokenKind::ParenClose, open);
    close(TokenKind::ParenClose, open, "',' or ");
    return run;
}

Run Parser::parameters(std::string_view after) {
    const Token open = expect(TokenKind::ParenOpen, after);
    const std::size_t mark = pending_arguments_.size();
    while (!at(TokenKind::ParenClose)) {
        if (pending_arguments_.size() > mark && !accept(TokenKind::Comma)) {
            close(TokenKind::ParenClose, open, "',' or ");
        }
        if (pending_arguments_.size() > mark && at(TokenKind::ParenClose)) {
            break;
        }
        Argument a;
        const Token name = expect_name("the name of a parameter");
        a.name = name.name;
        if (accept(TokenKind::Assign)) {
            a.value = expression();
        }
        a.where = from(name.where);
        pending_arguments_.push_back(a);
    }
    take();
    return gather(mark);
}

}  // namespace csg::scad
