#include "ui/pipeline/editing/statement_pieces.h"

#include <algorithm>

namespace ui {

namespace {

using csg::scad::ByteRange;

struct Token {
    enum class Kind : char { Word, Sign, File, Other };
    Kind kind = Kind::Other;
    ByteRange bytes;
};

std::size_t length(const ByteRange& bytes) {
    return bytes.end - bytes.begin;
}

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '$';
}

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

/// Behind a comment that begins there; `at` itself where none does.
std::size_t behind_comment(std::string_view text, std::size_t at) {
    if (text.substr(at, 2) == "//") {
        return std::min(text.find('\n', at), text.size());
    }
    if (text.substr(at, 2) == "/*") {
        const std::size_t end = text.find("*/", at + 2);
        return end == std::string_view::npos ? text.size() : end + 2;
    }
    return at;
}

std::size_t behind_string(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        at += text[at] == '\\' ? 1 : 0;
    }
    return std::min(at + 1, text.size());
}

/// Without comments and white space.
std::vector<Token> tokens_of(std::string_view text) {
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = at;
        const char c = text[at];
        if (is_blank(c)) {
            ++at;
            continue;
        }
        if (at = behind_comment(text, begin); at > begin) {
            continue;
        }
        const std::string_view before =
            tokens.empty() ? "" : text.substr(tokens.back().bytes.begin, length(tokens.back().bytes));
        const bool names_file = c == '<' && (before == "include" || before == "use");
        Token token{Token::Kind::Other, {begin, begin + 1}};
        if (names_file) {
            token = {Token::Kind::File, {begin, std::min(text.find('>', begin), text.size() - 1) + 1}};
        } else if (c == '"') {
            token.bytes.end = behind_string(text, begin);
        } else if (is_word(c)) {
            token.kind = Token::Kind::Word;
            while (token.bytes.end < text.size() && is_word(text[token.bytes.end])) {
                ++token.bytes.end;
            }
        } else if (std::string_view("(){}[];=").find(c) != std::string_view::npos) {
            token.kind = Token::Kind::Sign;
        }
        at = token.bytes.end;
        tokens.push_back(token);
    }
    return tokens;
}

/// Behind the comments that stand alone on the rest of the line, and its end; `at` itself where something else does.
std::size_t behind_line(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && text[end] != '\n') {
        const std::size_t behind = behind_comment(text, end);
        const bool one_line = text.substr(end, behind - end).find('\n') == std::string_view::npos;
        if (behind > end && one_line) {
            end = behind;
        } else if (is_blank(text[end])) {
            ++end;
        } else {
            return at;
        }
    }
    return std::min(end + 1, text.size());
}

/// Goes through the statements, which nest.
class StatementFinder {
  public:
    StatementFinder(std::string_view text, std::size_t offset)
        : text_(text), offset_(offset), tokens_(tokens_of(text)) {}

    std::optional<StatementText> find() {
        std::size_t i = 0;
        while (i < tokens_.size() && tokens_[i].bytes.begin <= offset_) {
            i = statement(i);
        }
        return found_;
    }

  private:
    static constexpr int kMostNesting = 1000;  ///< As the parser has it.
    /// Counts while it is there.
    class Depth {
      public:
        explicit Depth(int& depth) : depth_(depth) { ++depth_; }
        ~Depth() { --depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;

      private:
        int& depth_;
    };

    [[nodiscard]] bool is(std::size_t i, std::string_view what) const {
        return i < tokens_.size() && text_.substr(tokens_[i].bytes.begin, length(tokens_[i].bytes)) == what;
    }

    /// Behind what closes the bracket at `i`.
    [[nodiscard]] std::size_t behind_brackets(std::size_t i) const {
        int depth = 0;
        for (; i < tokens_.size(); ++i) {
            depth += is(i, "(") || is(i, "[") ? 1 : is(i, ")") || is(i, "]") ? -1 : 0;
            if (depth == 0) {
                return i + 1;
            }
        }
        return i;
    }

    /// The tokens behind the statement that begins at `i`. Chains are gone along in a loop: these may be long.
    std::size_t statement(std::size_t i) {
        if (is(i, "module")) {
            i = behind_brackets(i + 2);
            return i > tokens_.size() ? tokens_.size() : body(i, true);
        }
        return body(i, false);
    }

    std::size_t body(std::size_t first, bool sole) {
        const Depth depth(depth_);
        std::size_t i = depth_ > kMostNesting ? tokens_.size() : first;
        bool call = false;  // There has been something with parentheses: no assignment.
        while (i < tokens_.size()) {
            if (is(i, "(") || is(i, "[")) {
                i = behind_brackets(i);
                call = true;
            } else if (is(i, "{")) {
                i = block(i + 1);
                if (!is(i, "else")) {
                    break;
                }
                i = otherwise(i + 1);
                break;
            } else if (is(i, ";") || tokens_[i].kind == Token::Kind::File) {
                ++i;
                if (!is(i, "else") || !call) {
                    break;
                }
                i = otherwise(i + 1);
                break;
            } else if (is(i, "}")) {
                i = std::max(i, first + 1);  // Something is missing before it.
                break;
            } else {
                ++i;
            }
        }
        if (first < i && first < tokens_.size()) {
            take({tokens_[first].bytes.begin, tokens_[std::min(i, tokens_.size()) - 1].bytes.end}, sole);
        }
        return i;
    }

    /// What an else is followed by; an if there is part of the statement that the else belongs to.
    std::size_t otherwise(std::size_t i) {
        if (!is(i, "if")) {
            return body(i, true);
        }
        const std::optional<StatementText> before = found_;
        const std::size_t begin = i < tokens_.size() ? tokens_[i].bytes.begin : text_.size();
        i = body(i, true);
        if (found_ && found_->bytes.begin == begin) {
            found_ = before;
        }
        return i;
    }

    std::size_t block(std::size_t i) {
        while (i < tokens_.size() && !is(i, "}")) {
            i = statement(i);
        }
        return std::min(i + 1, tokens_.size());
    }

    /// Inner ones are taken before those that they are in.
    void take(const ByteRange& bytes, bool sole) {
        if (!found_ && bytes.begin <= offset_ && offset_ < bytes.end) {
            found_ = {bytes, sole};
        }
    }

    std::string_view text_;
    std::size_t offset_;
    std::vector<Token> tokens_;
    int depth_ = 0;
    std::optional<StatementText> found_;
};

}  // namespace

std::vector<ByteRange> statement_pieces(std::string_view text) {
    std::vector<ByteRange> pieces;
    std::size_t begin = 0;
    int depth = 0;
    for (const Token& token : tokens_of(text)) {
        const char c = text[token.bytes.begin];
        const bool sign = token.kind == Token::Kind::Sign;
        if (sign && (c == '(' || c == '[')) {
            ++depth;
        } else if (sign && (c == ')' || c == ']')) {
            depth = std::max(depth - 1, 0);
        }
        const bool brace = sign && (c == '{' || c == '}');
        if (brace) {
            depth = 0;  // Whatever was open was forgotten.
        }
        if (brace || token.kind == Token::Kind::File || (sign && c == ';' && depth == 0)) {
            const std::size_t end = behind_line(text, token.bytes.end);
            pieces.push_back({begin, end});
            begin = end;
        }
    }
    if (begin < text.size()) {
        pieces.push_back({begin, text.size()});
    }
    return pieces;
}

std::optional<StatementText> statement_at(std::string_view text, std::size_t offset) {
    return StatementFinder(text, offset).find();
}

}  // namespace ui
