// Vectors, ranges, list comprehensions, and lists of arguments and parameters.
#include <fmt/format.h>

#include "csg/scad/syntax/parser_impl.h"

namespace csg::scad {

ExprId Parser::vector_or_range() {
    const Token open = take();
    if (at(TokenKind::Comma) || at(TokenKind::BracketClose)) {
        skip_commas();
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
        while (next_item(TokenKind::BracketClose, open)) {
            pending_elements_.push_back(expression(Position::Element));
        }
    }
    close(TokenKind::BracketClose, open);
    Expr e;
    e.kind = ExprKind::Vector;
    e.list = append_run(program_.elements, pending_elements_, mark);
    e.where = from(open.where);
    return add(e);
}

ExprId Parser::list_for() {
    const Token word = take();
    const Token open = expect(TokenKind::ParenOpen, "after 'for'");
    Run update{};
    Expr e;
    e.kind = ExprKind::ListFor;
    e.list = arguments(open, true);
    if (accept(TokenKind::Semicolon)) {
        e.kind = ExprKind::ListForC;
        e.operands[1] = expression();
        expect(TokenKind::Semicolon, "after the condition of this 'for'");
        update = arguments(open);
    }
    close(TokenKind::ParenClose, open, "',' or ");
    e.operands[0] = expression(Position::Element);
    e.where = from(word.where);
    const ExprId id = add(e);
    if (e.kind == ExprKind::ListForC) {
        program_.updates.emplace(id, update);
    }
    return id;
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

/// OpenSCAD takes any number of commas for one.
void Parser::skip_commas() {
    while (accept(TokenKind::Comma)) {
    }
}

/// After an item of a list: whether another one follows.
bool Parser::next_item(TokenKind end, const Token& open, bool semicolon_ends) {
    const auto ended = [&] { return at(end) || (semicolon_ends && at(TokenKind::Semicolon)); };
    if (!ended() && !at(TokenKind::Comma)) {
        close(end, open, "',' or ");
    }
    skip_commas();
    return !ended();
}

Run Parser::arguments(const Token& open, bool semicolon_ends) {
    const std::size_t mark = pending_arguments_.size();
    skip_commas();
    bool more = !at(TokenKind::ParenClose) && !(semicolon_ends && at(TokenKind::Semicolon));
    for (; more; more = next_item(TokenKind::ParenClose, open, semicolon_ends)) {
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
    const Run run = arguments(open);
    close(TokenKind::ParenClose, open, "',' or ");
    return run;
}

Run Parser::parameters(std::string_view after) {
    const Token open = expect(TokenKind::ParenOpen, after);
    const std::size_t mark = pending_arguments_.size();
    skip_commas();
    for (bool more = !at(TokenKind::ParenClose); more; more = next_item(TokenKind::ParenClose, open)) {
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
