// The recursive-descent parser. Internal: use parser.h.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "csg/scad/syntax/block_builder.h"
#include "csg/scad/syntax/preparser.h"
#include "csg/scad/syntax/token_stream.h"

namespace csg::scad {

/// Ends the parsing of a file.
struct SyntaxError {
    SourceRange where;
    std::string text;
};

/// Parses one unit. Children come before parents in all of Program's arrays. Recursion is bounded by kMaxNesting;
/// what grows without brackets (see ast.h) is gathered in loops.
class Parser {
  public:
    /// `lazy`: bodies of definitions at top level are not built, where that is all there is to say about them.
    Parser(Files& files, UnitId unit, bool lazy);
    /// Of a file that becomes a piece. Both must outlive it.
    Parser(Program& part, std::uint32_t file, const MessageSink& sink) : program_(part), lazy_(true) {
        tokens_.emplace(part, file, sink);
    }
    /// Reads what comes after the main file's text: definitions.
    explicit Parser(Files& files) : files_(&files), program_(files.program()), unit_(0) {}
    /// Builds lazy bodies, and definitions that name no files.
    explicit Parser(Program& program) : program_(program) {}

    /// The block of the unit's file with what it includes. Throws SyntaxError.
    BlockId unit();
    /// The file by itself. Throws SyntaxError where it is no piece.
    void piece(Piece& piece);
    /// Whether an error may be but one of pieces that do not go together.
    [[nodiscard]] bool at_piece() const { return tokens_ && tokens_->at_piece(); }
    /// Assignments of the main file's unit that stand in another text, name=expression, more of them after semicolons.
    /// Throws SyntaxError.
    void definitions(std::uint32_t file, const MessageSink& sink, std::vector<Argument>& out);
    ExprId function_body(const LazyBody& body);
    BlockId module_body(const LazyBody& body);

  private:
    /// One more level while it lives.
    class Nesting {
      public:
        explicit Nesting(Parser& parser);
        ~Nesting() { --parser_.depth_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;

      private:
        Parser& parser_;
    };

    /// Where an expression stands. Elements of lists may also be for, if, each, and let around these.
    enum class Position : std::uint8_t { Plain, Element };

    /// A binary operator with its left side, before it is known whether the next operator binds tighter.
    struct PendingOperator {
        ExprId left = kNone;
        Operator op = Operator::None;
        int precedence = 0;
    };

    /// Where a statement stands: at the top of a file, inside the braces of a module, inside the braces of an
    /// instantiation (no definitions there), or as the one child without braces (no assignments either).
    enum class Level : std::uint8_t { Top, Module, Children, Child };

    // parser_tokens.cpp
    [[nodiscard]] const Token& current() const { return tokens_->current(); }
    [[nodiscard]] bool at(TokenKind kind) const { return tokens_->current().kind == kind; }
    [[nodiscard]] bool at_assignment() const;
    [[nodiscard]] bool at_module_name() const;
    [[nodiscard]] bool begins_child() const;
    const Token& take() { return tokens_->take(); }
    bool accept(TokenKind kind);
    /// `context` goes after "expected '…'": "after the name of the module".
    Token expect(TokenKind kind, std::string_view context);
    Token expect_name(std::string_view what);
    void expect_semicolon(std::string_view after);
    /// The bracket that closes `open`.
    Token close(TokenKind kind, const Token& open, std::string_view also = {});
    [[noreturn]] void fail(const SourceRange& where, std::string text) const;
    /// "expected …, found …", or what the lexer has to say about the current token.
    [[noreturn]] void fail_expected(std::string_view expected) const;
    [[nodiscard]] std::string found() const;
    [[nodiscard]] SourceRange after_previous() const;
    [[nodiscard]] SourceRange from(const SourceRange& first) const { return spanning(first, tokens_->previous()); }

    // parser_expressions.cpp
    ExprId expression(Position position = Position::Plain);
    ExprId unconditional(Position position);
    ExprId binary(Position position);
    ExprId unary(Position position);
    ExprId power(Position position);
    ExprId postfix(Position position);
    ExprId primary(Position position);
    ExprId parenthesised(Position position);
    ExprId negated(ExprId operand, const SourceRange& sign);
    ExprId literal(ExprKind kind, double number = 0);
    ExprId function_literal();
    ExprId let(Position position);
    ExprId assert_or_echo(ExprKind kind);
    ExprId call(ExprId callee);
    ExprId index(ExprId value);
    ExprId member(ExprId value);
    [[nodiscard]] bool begins_expression() const;
    [[nodiscard]] bool is_element(ExprId e) const;
    /// Counts its links, and adds it to the program.
    ExprId add(Expr& e);

    // parser_lists.cpp
    ExprId vector_or_range();
    ExprId range(const Token& open, ExprId begin);
    ExprId vector(const Token& open, ExprId first);
    ExprId list_for();
    ExprId list_if();
    ExprId list_each();
    void skip_commas();
    bool next_item(TokenKind end, const Token& open, bool semicolon_ends = false);
    /// Up to the parenthesis that closes `open`, or a semicolon where that may end them; neither is taken.
    Run arguments(const Token& open, bool semicolon_ends = false);
    /// In parentheses.
    Run call_arguments(std::string_view after);
    Run parameters(std::string_view after);
    Run gather(std::size_t mark);

    // parser_statements.cpp
    void statement(BlockBuilder& block, Level level);
    PieceStatements piece_statements();
    void place_piece(BlockBuilder& block);
    void braces(BlockBuilder& block, Level level);
    void assignment(BlockBuilder& block);
    void module_definition(BlockBuilder& block, Level level);
    void function_definition(BlockBuilder& block, Level level);
    /// Whether what comes now is a body that need not be built: `read`, of a Preparser, reads it. Then it is passed
    /// over, and `lazy` is its index.
    bool pass_over(std::size_t (Preparser::*read)(std::size_t), Level level, std::uint32_t& lazy);
    bool warn_overwritten(const Argument& assignment, const SourceRange& before) const;
    Modifiers modifiers();
    Instantiation instantiation();
    Instantiation if_chain(Modifiers modifiers);
    template <typename Text>
    BlockId children(const Text& of);
    BlockId block_of(const Instantiation& only);
    [[noreturn]] void fail_statement(Level level) const;

    Files* files_ = nullptr;  ///< Null for what names no files.
    Program& program_;
    UnitId unit_ = kNone;
    bool lazy_ = false;
    std::optional<TokenStream> tokens_;  ///< Never empty; replaced for each definition of the command line.
    int depth_ = 0;
    std::vector<Argument> pending_arguments_;  ///< Of lists under way, the innermost last.
    std::vector<ExprId> pending_elements_;
    std::vector<PendingOperator> pending_operators_;
};

}  // namespace csg::scad
