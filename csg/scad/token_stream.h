// The tokens of a unit: of its file, and in the place of each include those of the included file. Internal to the
// parser.
#pragma once

#include <vector>

#include "csg/scad/lexer.h"
#include "csg/scad/parser_files.h"

namespace csg::scad {

class TokenStream {
  public:
    /// Starts with the file `root`, for `unit`; `files` must outlive it.
    TokenStream(Files& files, std::uint32_t root, UnitId unit);

    [[nodiscard]] const Token& current() const { return current_; }
    /// The one after it.
    [[nodiscard]] const Token& next() const { return next_; }
    /// Where the token taken last was. Not known() at the start.
    [[nodiscard]] const SourceRange& previous() const { return previous_; }
    /// Takes the current token. The last one, of kind End or Error, stays.
    Token take();

  private:
    [[nodiscard]] Token read();
    [[nodiscard]] Token too_much(const Token& include, std::string text);
    bool enter(const Token& include, Token& failed);

    Files& files_;
    UnitId unit_;
    std::vector<Lexer> lexers_;        ///< Of files under way, the innermost last.
    std::vector<std::uint32_t> open_;  ///< The included ones: without the first.
    SourceRange previous_;
    Token current_;
    Token next_;
};

}  // namespace csg::scad
