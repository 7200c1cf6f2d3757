// Files that are parsed by themselves, and what is put in the place of their tokens.
#include "csg/scad/syntax/parser_impl.h"

namespace csg::scad {

void Parser::piece(Piece& piece) {
    while (!at(TokenKind::End)) {
        PieceStep& step = piece.steps.emplace_back();
        step.statements = piece_statements();
        if (at(TokenKind::Include) || at(TokenKind::Use)) {
            const Token file = take();
            step.then = file.kind == TokenKind::Use ? PieceStep::Then::Use : PieceStep::Then::Include;
            step.name = file.name;
            step.where = file.where;
        }
    }
    piece.end = current().where;
}

PieceStatements Parser::piece_statements() {
    BlockBuilder block;
    block.keep_all();
    const Token first = current();
    std::size_t before_last = 0, before_two = 0;  // Assignments before the last statement, and the last two.
    while (!at(TokenKind::End) && !at(TokenKind::Include) && !at(TokenKind::Use)) {
        before_two = before_last;
        before_last = block.assignment_count();
        statement(block, Level::Top);
    }
    PieceStatements statements = block.take();
    statements.last_assignments = statements.assignments.size() - before_two;
    if (statements.empty() && !(first.where == current().where)) {
        fail(first.where, {});  // Tokens that leave no trace, but may end what stands before them.
    }
    return statements;
}

void Parser::place_piece(BlockBuilder& block) {
    const auto [statements, placed] = tokens_->piece();
    const std::size_t count = statements->assignments.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Argument a = placed->placed(statements->assignments[i]);
        if (const auto before = block.assign(a);
            before && warn_overwritten(a, *before) && i + statements->last_assignments >= count) {
            throw PieceMisfit();
        }
    }
    for (const FunctionDefinition& f : statements->functions) {
        block.add(placed->placed(f));
    }
    for (const ModuleDefinition& m : statements->modules) {
        block.add(placed->placed(m));
    }
    for (const Instantiation& i : statements->instantiations) {
        block.add(placed->placed(i));
    }
    take();
}

}  // namespace csg::scad
