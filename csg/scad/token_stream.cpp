#include "csg/scad/token_stream.h"

#include <fmt/format.h>

namespace csg::scad {

TokenStream::TokenStream(Files& files, std::uint32_t root, UnitId unit) : files_(files), unit_(unit) {
    Program& program = files.program();
    lexers_.emplace_back(program.sources[root].text(), root, program.symbols, files.sink());
    tokens_[0] = read();
    tokens_[1] = read();
}

const Token& TokenStream::take() {
    const Token& taken = current();
    const Token& after = next();
    ++at_;
    const bool last = after.kind == TokenKind::End || after.kind == TokenKind::Error;
    tokens_[(at_ + 1) % kKept] = last ? after : read();
    return taken;
}

Token TokenStream::read() {
    for (;;) {
        const Token token = lexers_.back().take();
        if (token.kind == TokenKind::End && lexers_.size() > 1) {
            lexers_.pop_back();
            open_.pop_back();
        } else if (token.kind == TokenKind::Include) {
            if (Token failed; !enter(token, failed)) {
                return failed;
            }
        } else {
            if (token.kind == TokenKind::Use) {
                files_.use(files_.program().symbols.text(token.name), token.where.file, unit_, token.where);
            }
            return token;
        }
    }
}

/// False where a limit is passed. A file that is not found is passed over.
bool TokenStream::enter(const Token& include, Token& failed) {
    Program& program = files_.program();
    const auto file = files_.include(program.symbols.text(include.name), include.where.file, open_, include.where);
    if (!file) {
        return true;
    }
    if (open_.size() >= kMaxIncludeDepth) {
        failed = too_much(include, fmt::format("included files nest deeper than {} levels", kMaxIncludeDepth));
        return false;
    }
    if (!files_.account(*file)) {
        failed = too_much(include, fmt::format("included files are more than {}, or larger than {} MiB in all",
                                               kMaxInclusions, kMaxSourceBytes >> 20));
        return false;
    }
    lexers_.emplace_back(program.sources[*file].text(), *file, program.symbols, files_.sink());
    open_.push_back(*file);
    return true;
}

Token TokenStream::too_much(const Token& include, std::string text) {
    Token failed;
    failed.kind = TokenKind::Error;
    failed.name = files_.program().symbols.intern(text);
    failed.where = include.where;
    return failed;
}

}  // namespace csg::scad
