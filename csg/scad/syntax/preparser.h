// A parser that builds nothing: it finds out whether the body of a definition is well formed, and where it ends, in a
// fifth of the time that building it takes. It knows the grammar of the parser (parser_impl.h) but none of its
// messages: whatever is odd in the least, such as an error, a warning or an include, it refuses, and the parser has its
// say. So it never decides more than that a piece of text is beyond doubt.
//
// Besides, it notes what must be known of a body that is not built: all names that begin with `$`, which go into the
// table of symbols, and what LazyBodies has room for.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "csg/scad/source/characters.h"
#include "csg/scad/syntax/lazy_body.h"
#include "csg/scad/syntax/token.h"
#include "csg/scad/value/symbols.h"

namespace csg::scad {

class Preparser {
  public:
    /// `text` is that of a file. All three must outlive it; `notes` grows also by what is refused.
    Preparser(const std::string& text, SymbolTable& symbols, LazyBodies& notes);

    /// What follows the `=` of a function, with its semicolon; begins at a token. The offset behind it; 0: refused.
    [[nodiscard]] std::size_t function_body(std::size_t begin);
    /// What follows the parameters of a module: its one statement.
    [[nodiscard]] std::size_t module_body(std::size_t begin);

    /// How much deeper than where it begins a body may nest in the parser's reckoning. (kMaxDepth levels of this class,
    /// with an expression and its signs and powers in each.)
    static constexpr int kMostNesting = 600;

  private:
    enum class Outcome : std::uint8_t { Refused, Value, Element };
    enum class Position : std::uint8_t { Plain, Element };
    enum class Level : std::uint8_t { Module, Children, Child };  ///< As Parser::Level, within a module.

    static constexpr CharacterSet kMaybeBlank{" \t\n\r\f\v/"};
    static constexpr CharacterSet kWordBegin{"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_$"};
    static constexpr int kMaxDepth = 60;
    static constexpr int kMaxChain = 8;  ///< Signs and powers of one operand.

    /// One more level while it lives.
    class Nesting {
      public:
        explicit Nesting(Preparser& p) : p_(p) { ++p_.depth_; }
        ~Nesting() { --p_.depth_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;
        [[nodiscard]] bool too_deep() const { return p_.depth_ > kMaxDepth; }

      private:
        Preparser& p_;
    };

    // preparser.cpp: tokens. `at_` is always at the beginning of one.

    void start(std::size_t begin);
    void skip_blanks() {
        at_ += *at_ == ' ' ? 1 : 0;  // What mostly stands between tokens, if anything does.
        if (kMaybeBlank.has(*at_)) {
            skip_more_blanks();
        }
    }
    void skip_more_blanks();
    void skip(std::size_t bytes) {
        at_ += bytes;
        skip_blanks();
    }
    bool accept(char sign) {
        const bool found = *at_ == sign;
        if (found) {
            skip(1);
        }
        return found;
    }
    [[nodiscard]] bool at_word() const { return kWordBegin.has(*at_); }
    [[nodiscard]] bool at_number() const { return is_digit(*at_) || (*at_ == '.' && is_digit(at_[1])); }
    [[nodiscard]] bool at_assign() const { return *at_ == '=' && at_[1] != '='; }
    [[nodiscard]] bool at_not() const { return *at_ == '!' && at_[1] != '='; }
    /// Takes a word; its text is in `word_`. Error where it is not beyond doubt.
    TokenKind word();
    /// Takes that word if it is the next token.
    bool accept_word(std::string_view expected);
    bool number();
    bool string();

    // preparser_expressions.cpp. `first`: a word taken before, with which the expression begins.

    Outcome expression(Position position = Position::Plain, TokenKind first = TokenKind::End);
    bool value(TokenKind first = TokenKind::End) { return expression(Position::Plain, first) == Outcome::Value; }
    Outcome unconditional(Position position, TokenKind first);
    Outcome operation(Position position, bool has_operand);
    Outcome operand(Position position, int& chain);
    enum class After : std::uint8_t { Refused, Operator, Power, Nothing };
    After after_operand();
    bool assert_or_echo();
    bool vector_or_range();
    Outcome list_for();
    Outcome list_if();
    void skip_commas();
    /// Behind an item of a list: the end, or a comma.
    bool end_item(char end, bool semicolon_ends = false);
    bool arguments(Symbol module = kNoSymbol, bool semicolon_ends = false);
    bool call_arguments(Symbol module = kNoSymbol) { return accept('(') && arguments(module) && accept(')'); }
    bool parameters();

    // preparser_statements.cpp. `block`: where the names of the block's variables begin in `assigned_`.

    bool statement(Level level, std::size_t block);
    bool braces(Level level, std::size_t block);
    bool assignment(std::size_t block);
    bool function_definition();
    bool module_definition();
    bool end_statement();
    bool modified_instantiation();
    bool instantiation(TokenKind name);
    bool if_chain();
    bool children();

    const std::string& text_;
    const char* const text_end_;
    SymbolTable& symbols_;
    LazyBodies& notes_;
    const char* at_ = nullptr;
    const char* end_ = nullptr;  ///< Behind the statement taken last.
    int depth_ = 0;
    std::string_view word_;
    std::vector<std::uint64_t> assigned_;  ///< Hashes of the names of variables, of blocks under way.
};

}  // namespace csg::scad
