#include "csg/scad/syntax/token_stream.h"

#include <fmt/format.h>

#include "csg/scad/syntax/definitions.h"

namespace csg::scad {

namespace {

bool is_last(const Token& token) {
    return token.kind <= TokenKind::Error;
}

/// Nothing is read behind it yet.
bool is_barrier(const Token& token) {
    return token.kind <= TokenKind::Piece;
}

const MessageSink kSilence;

}  // namespace

TokenStream::TokenStream(Files& files, std::uint32_t root, UnitId unit) : files_(&files), unit_(unit) {
    open(root);
    read(tokens_[0]);
    read_next();
}

TokenStream::TokenStream(Program& program, std::uint32_t file, const MessageSink& sink) {
    lexers_.emplace_back(program.sources[file].text(), file, program.symbols, sink);
    read(tokens_[0]);
    read_next();
}

TokenStream::TokenStream(Program& program, const LazyBody& body) {
    const std::string_view text = std::string_view(program.sources[body.file].text()).substr(0, body.end);
    lexers_.emplace_back(text, body.file, program.symbols, kSilence,
                         Lexer::Place{body.begin, body.line, body.begin - (body.column - 1)});
    read(tokens_[0]);
    read_next();
}

bool TokenStream::can_skip() const {
    if (in_piece() || next().kind == TokenKind::Piece) {
        return false;
    }
    // A lexer of another time that the same file is included has not come as far as this token, or is at its end.
    const Lexer& lexer = lexers_.back();
    return !is_last(current()) && lexer.file() == current().where.file && lexer.place().at > current().at;
}

void TokenStream::skip(std::size_t end) {
    const SourceRange& where = current().where;
    Lexer& lexer = lexers_.back();
    lexer.go_on({current().at, where.line, current().at - (where.column - 1)}, end);
    const Lexer::Place& place = lexer.place();
    const auto column = static_cast<std::uint32_t>(place.at - place.line_start);
    Token sign;
    sign.at = static_cast<std::uint32_t>(end) - 1;
    sign.where = {lexer.file(), place.line, column, place.line, column + 1};
    tokens_[at_ % kKept] = sign;
    ++at_;
    read(tokens_[at_ % kKept]);
    read_next();
}

const Token& TokenStream::take() {
    const Token& taken = current();
    ++at_;
    if (taken.kind == TokenKind::Piece) {
        read(tokens_[at_ % kKept]);
    }
    read_next();
    return taken;
}

/// The one after the current one; the last one is followed by itself, and so is a piece: what comes behind is not read
/// before it is put in its place, so that messages keep their order.
void TokenStream::read_next() {
    Token& after = tokens_[(at_ + 1) % kKept];
    if (is_barrier(current())) {
        after = current();
    } else {
        read(after);
    }
}

std::pair<const PieceStatements*, const PlacedPiece*> TokenStream::piece() {
    Cursor& cursor = cursors_.back();
    if (!cursor.placed) {
        cursor.placed.emplace(*cursor.piece, files_->program(), cursor.file);
    }
    return {&cursor.piece->steps[cursor.step].statements, &*cursor.placed};
}

void TokenStream::read(Token& token) {
    for (;;) {
        if (in_piece()) {
            if (read_piece(token)) {
                return;
            }
            continue;
        }
        token = lexers_.back().take();
        if (token.kind > TokenKind::Use) {
            return;
        }
        if (token.kind == TokenKind::End && lexers_.size() + cursors_.size() > 1) {
            lexers_.pop_back();
            open_.pop_back();
        } else if (files_ == nullptr) {
            return;
        } else if (token.kind == TokenKind::Include) {
            if (Token failed; !enter(token, files_->program().symbols.text(token.name), failed)) {
                token = failed;
                return;
            }
        } else {
            if (token.kind == TokenKind::Use) {
                files_->use(files_->program().symbols.text(token.name), token.where.file, unit_, token.where);
            }
            return;
        }
    }
}

/// False where it gives no token, but the next is to be read from elsewhere.
bool TokenStream::read_piece(Token& token) {
    Cursor& cursor = cursors_.back();
    token = {};
    if (cursor.step == cursor.piece->steps.size()) {
        if (lexers_.size() + cursors_.size() > 1) {
            cursors_.pop_back();
            open_.pop_back();
            return false;
        }
        token.where = cursor.piece->end;  // That of the unit.
        token.where.file = cursor.file;
        return true;
    }
    const PieceStep& step = cursor.piece->steps[cursor.step];
    if (!cursor.given && !step.statements.empty()) {
        cursor.given = true;
        token.kind = TokenKind::Piece;
        return true;
    }
    cursor.given = false;
    ++cursor.step;
    if (step.then == PieceStep::Then::Nothing) {
        return false;
    }
    token.where = step.where;
    token.where.file = cursor.file;
    const std::string& name = cursor.piece->part.symbols.text(step.name);
    if (step.then == PieceStep::Then::Use) {
        token.kind = TokenKind::Use;
        files_->use(name, cursor.file, unit_, token.where);
        return true;
    }
    const Token include = token;
    return !enter(include, name, token);  // The token of the failure, if it fails.
}

void TokenStream::open(std::uint32_t file) {
    Program& program = files_->program();
    // Definitions are taken apart by assignments, which a piece has put together already.
    const bool definition = program.sources[file].name() == kCommandLine;
    if (auto piece = definition ? nullptr : files_->piece(file)) {
        cursors_.push_back({std::move(piece), file, lexers_.size()});
    } else {
        lexers_.emplace_back(program.sources[file].text(), file, program.symbols, files_->sink());
    }
}

/// False where a limit is passed. A file that is not found is passed over.
bool TokenStream::enter(const Token& include, const std::string& name, Token& failed) {
    const auto file = files_->include(name, include.where.file, open_, include.where);
    if (!file) {
        return true;
    }
    if (open_.size() >= kMaxIncludeDepth) {
        failed = too_much(include, fmt::format("included files nest deeper than {} levels", kMaxIncludeDepth));
        return false;
    }
    if (!files_->account(*file)) {
        failed = too_much(include, fmt::format("included files are more than {}, or larger than {} MiB in all",
                                               kMaxInclusions, kMaxSourceBytes >> 20));
        return false;
    }
    open(*file);
    open_.push_back(*file);
    return true;
}

Token TokenStream::too_much(const Token& include, std::string_view text) {
    Token failed;
    failed.kind = TokenKind::Error;
    failed.name = files_->program().symbols.intern(text);
    failed.where = include.where;
    return failed;
}

}  // namespace csg::scad
