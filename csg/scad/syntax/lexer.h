// From characters to tokens, one at a time.
#pragma once

#include <string_view>

#include "csg/scad/source/diagnostics.h"
#include "csg/scad/source/source.h"
#include "csg/scad/syntax/token.h"

namespace csg::scad {

/// Reads one file. What is odd but accepted (an unknown escape, a hexadecimal number out of range) is a warning; what
/// is no token at all is a token of kind Error, and nothing comes after it but its repetition.
class Lexer {
  public:
    /// A place between tokens.
    struct Place {
        std::size_t at = 0;
        std::uint32_t line = 1;
        std::size_t line_start = 0;
    };

    /// `text`, `symbols` and `sink` must outlive the lexer. A zero, or nothing that belongs to a word or number,
    /// follows the text. `file` is the index for ranges.
    Lexer(std::string_view text, std::uint32_t file, SymbolTable& symbols, const MessageSink& sink);
    /// Reads a piece of a file only, from `begin` on; `text` is the file's up to where the piece ends.
    Lexer(std::string_view text, std::uint32_t file, SymbolTable& symbols, const MessageSink& sink, const Place& begin);

    /// End forever, once the text is used up.
    [[nodiscard]] Token take();
    [[nodiscard]] std::uint32_t file() const { return file_; }
    /// Behind the token taken last.
    [[nodiscard]] const Place& place() const { return place_; }
    /// Goes on at `at`, which lies behind `from`, a place in this text.
    void go_on(Place from, std::size_t at);

  private:
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return place_.at + ahead < text_.size() ? text_[place_.at + ahead] : '\0';
    }
    [[nodiscard]] bool at_end() const { return place_.at >= text_.size(); }
    [[nodiscard]] std::uint32_t column() const { return static_cast<std::uint32_t>(place_.at - place_.line_start) + 1; }
    [[nodiscard]] SourceRange since(const Place& begin) const;
    [[nodiscard]] Token finish(TokenKind kind, const Place& begin) const;
    Token error(const Place& begin, std::string_view text);
    void warn(const SourceRange& where, std::string text) const;

    void advance();       ///< By one byte, or a line end of two.
    bool skip_blanks();   ///< White space and comments; false at a comment that never ends.
    bool skip_comment();  ///< False where it never ends.
    [[nodiscard]] std::size_t blank_bytes() const;
    [[nodiscard]] std::string character_name() const;

    Token word(const Place& begin, std::size_t length);
    Token number(const Place& begin, std::size_t length);
    /// Reads most numbers; false, and nothing, where it takes more.
    bool short_number(const Place& begin, Token& token);
    Token hexadecimal(const Place& begin, std::size_t length);
    Token string(const Place& begin);
    Token punctuation(const Place& begin);
    /// After `include` or `use`: the name in angle brackets. `begin` is of the keyword.
    Token file_name(TokenKind kind, const Place& begin);
    [[nodiscard]] std::size_t number_length() const;
    [[nodiscard]] std::size_t word_length() const;
    [[nodiscard]] bool angle_bracket_follows(std::size_t keyword_length) const;
    void escape(std::string& out);
    char32_t hexadecimal_escape(std::size_t digits);

    std::string_view text_;
    std::uint32_t file_;
    SymbolTable& symbols_;
    const MessageSink& sink_;
    Place place_;
    Token failed_;  ///< The Error token, once there was one.
};

}  // namespace csg::scad
