// The tokens of a unit: of its file, and in the place of each include those of the included file. Internal to the
// parser.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "csg/scad/syntax/lexer.h"
#include "csg/scad/syntax/parser_files.h"
#include "csg/scad/syntax/piece.h"

namespace csg::scad {

class TokenStream {
  public:
    /// Starts with the file `root`, for `unit`; `files` must outlive it.
    TokenStream(Files& files, std::uint32_t root, UnitId unit);
    /// Of a file of the program alone: includes and uses are tokens. All must outlive it.
    TokenStream(Program& program, std::uint32_t file, const MessageSink& sink);
    /// Of a body that was read before without finding anything to say. The program must outlive it.
    TokenStream(Program& program, const LazyBody& body);

    [[nodiscard]] const Token& current() const { return tokens_[at_ % kKept]; }
    /// The one after it.
    [[nodiscard]] const Token& next() const { return tokens_[(at_ + 1) % kKept]; }
    /// Where the token taken last was. Not known() at the start.
    [[nodiscard]] const SourceRange& previous() const { return tokens_[(at_ + kKept - 1) % kKept].where; }
    /// Takes the current token, which is to be copied where it is needed after two more are taken. The last one, of
    /// kind End or Error, stays.
    const Token& take();
    /// Whether the current token, or the one taken last, stands for statements that are parsed already.
    [[nodiscard]] bool at_piece() const {
        return current().kind == TokenKind::Piece || tokens_[(at_ + kKept - 1) % kKept].kind == TokenKind::Piece;
    }
    /// Where the current token is a piece: its statements, and what they are in the program.
    [[nodiscard]] std::pair<const PieceStatements*, const PlacedPiece*> piece();
    /// Whether the current token is of the file that is being read, with nothing of others read behind it.
    [[nodiscard]] bool can_skip() const;
    /// Passes over what the current token begins, up to `end` in its file. The last byte is a token, a sign.
    void skip(std::size_t end);

  private:
    /// A file that is a piece, under way.
    struct Cursor {
        std::shared_ptr<const Piece> piece;
        std::uint32_t file;
        std::size_t below;  ///< Lexers of files around it.
        std::size_t step = 0;
        bool given = false;  ///< The statements of the step.
        std::optional<PlacedPiece> placed{};
    };
    void open(std::uint32_t file);
    [[nodiscard]] bool in_piece() const { return !cursors_.empty() && cursors_.back().below == lexers_.size(); }
    bool read_piece(Token& token);
    void read(Token& token);
    void read_next();
    [[nodiscard]] Token too_much(const Token& include, std::string_view text);
    bool enter(const Token& include, const std::string& name, Token& failed);

    Files* files_ = nullptr;  ///< Null for what names no files.
    UnitId unit_ = kNone;
    std::vector<Lexer> lexers_;        ///< Of files under way, the innermost last.
    std::vector<Cursor> cursors_;      ///< Of those that are pieces; each is inside so many of the lexers.
    std::vector<std::uint32_t> open_;  ///< The included ones: without the first.
    static constexpr std::size_t kKept = 4;
    std::array<Token, kKept> tokens_;  ///< The previous one, the current one, and the next.
    std::size_t at_ = 0;               ///< Of the current one, counted on.
};

}  // namespace csg::scad
