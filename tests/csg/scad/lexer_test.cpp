#include "csg/scad/syntax/lexer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

namespace {

using namespace csg::scad;

struct Lexed {
    std::vector<Token> tokens;  ///< Without End.
    std::vector<Message> messages;
    SymbolTable symbols;
};

Lexed lex(std::string_view text) {
    Lexed result;
    const MessageSink sink = [&](const Message& message) { result.messages.push_back(message); };
    Lexer lexer(text, 0, result.symbols, sink);
    for (Token token = lexer.take(); token.kind != TokenKind::End; token = lexer.take()) {
        result.tokens.push_back(token);
        if (token.kind == TokenKind::Error) {
            break;
        }
    }
    return result;
}

/// Numbers as they are, names in quotes, signs and words as written.
std::string tokens(std::string_view text) {
    const Lexed lexed = lex(text);
    std::string all;
    for (const Token& token : lexed.tokens) {
        all += all.empty() ? "" : " ";
        switch (token.kind) {
            case TokenKind::Number:
                all += fmt::format("#{:f}", token.number);
                break;
            case TokenKind::String:
                all += fmt::format("\"{}\"", lexed.symbols.text(token.name));
                break;
            case TokenKind::Identifier:
                all += fmt::format("'{}'", lexed.symbols.text(token.name));
                break;
            case TokenKind::Include:
                all += "include:" + lexed.symbols.text(token.name);
                break;
            case TokenKind::Use:
                all += "use:" + lexed.symbols.text(token.name);
                break;
            case TokenKind::Error:
                all += "error:" + lexed.symbols.text(token.name);
                break;
            default:
                all += token_text(token.kind);
        }
    }
    return all;
}

double number(std::string_view text) {
    const Lexed lexed = lex(text);
    EXPECT_EQ(lexed.tokens.size(), 1U) << text;
    EXPECT_EQ(lexed.tokens.at(0).kind, TokenKind::Number) << text;
    return lexed.tokens.at(0).number;
}

std::string string(std::string_view text) {
    const Lexed lexed = lex(text);
    EXPECT_EQ(lexed.tokens.size(), 1U) << text;
    EXPECT_EQ(lexed.tokens.at(0).kind, TokenKind::String) << text;
    return lexed.symbols.text(lexed.tokens.at(0).name);
}

TEST(Lexer, EverySignIsReadBack) {
    const std::string signs = "( ) [ ] { } , ; : ? . = ! # % * + - / ^ ~ < <= > >= == != && || & | << >>";
    EXPECT_EQ(tokens(signs), signs);
}

TEST(Lexer, TheLongestSignCounts) {
    EXPECT_EQ(tokens("<<=>>===!==&&&|||"), "<< = >> == = != = && & || |");
    EXPECT_EQ(tokens("a<-b"), "'a' < - 'b'");
    EXPECT_EQ(tokens("[1:-1]"), "[ #1.000000 : - #1.000000 ]");
}

TEST(Lexer, EveryWordIsReadBack) {
    const std::string words = "module function if else for let assert echo each true false undef";
    EXPECT_EQ(tokens(words), words);
    EXPECT_EQ(tokens("modules iff True"), "'modules' 'iff' 'True'");
}

TEST(Lexer, Names) {
    EXPECT_EQ(tokens("a _b $c d1 _ $_ $1"), "'a' '_b' '$c' 'd1' '_' '$_' '$1'");
    EXPECT_EQ(tokens("$"), "error:unexpected character '$'");
    EXPECT_EQ(tokens("include use"), "'include' 'use'");  // Words only before a file name.
}

TEST(Lexer, NamesMayBeginWithADigitForNow) {
    EXPECT_EQ(tokens("2d 1e 0x 0xg 3_"), "'2d' '1e' '0x' '0xg' '3_'");
    const Lexed lexed = lex("2d");
    ASSERT_EQ(lexed.messages.size(), 1U);
    EXPECT_EQ(lexed.messages[0].severity, Severity::Deprecated);
}

TEST(Lexer, Numbers) {
    EXPECT_EQ(number("0"), 0);
    EXPECT_EQ(number("1."), 1);
    EXPECT_EQ(number(".5"), 0.5);
    EXPECT_EQ(number("1e3"), 1000);
    EXPECT_EQ(number("21.e-3"), 0.021);
    EXPECT_EQ(number(".11E-12"), .11e-12);
    EXPECT_EQ(number("1e+2"), 100);
    EXPECT_EQ(number("0123"), 123);
    EXPECT_EQ(number("0x1F"), 31);
    EXPECT_EQ(number("0XfF"), 255);
    EXPECT_EQ(tokens("1.5x"), "#1.500000 'x'");
    EXPECT_EQ(tokens("1..2"), "#1.000000 #0.200000");
    EXPECT_EQ(tokens("."), ".");
}

/// However many digits there are before and behind the point.
TEST(Lexer, NumbersAreTheNearestDoubles) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20'000; ++i) {
        std::string text;
        for (std::size_t digits = 1 + random() % 19; text.size() < digits;) {
            text += static_cast<char>('0' + random() % 10);
        }
        text.insert(random() % (text.size() + 1), 1, '.');
        ASSERT_EQ(number(text), std::strtod(text.c_str(), nullptr)) << text;
    }
}

TEST(Lexer, NumbersOutOfRange) {
    EXPECT_EQ(number("1e999"), std::numeric_limits<double>::infinity());
    EXPECT_EQ(number(std::string(400, '9')), std::numeric_limits<double>::infinity());
    EXPECT_EQ(number("1e-999"), 0);
    EXPECT_EQ(number(fmt::format(".{:0>401}", 1)), 0);
    EXPECT_EQ(number("1e99999999999999999999"), std::numeric_limits<double>::infinity());
    EXPECT_EQ(number("1e-99999999999999999999"), 0);
    EXPECT_EQ(number("0e999"), 0);
}

TEST(Lexer, IntegersThatADoubleCannotHoldAreWarnings) {
    const std::pair<const char*, const char*> cases[] = {
        {"0x10000000000000000", "Hexadecimal constant \"0x10000000000000000\" too large"},
        {"0x1000000000000001", "Integer \"0x1000000000000001\" cannot be represented precisely"},
        {"1152921504606846977", "Integer \"1152921504606846977\" cannot be represented precisely"},
    };
    for (const auto& [text, warning] : cases) {
        const Lexed lexed = lex(text);
        ASSERT_EQ(lexed.messages.size(), 1U) << text;
        EXPECT_EQ(lexed.messages[0].text, warning);
        EXPECT_TRUE(lexed.messages[0].parsing);
    }
    for (const char* text : {"9007199254740992", "0x20000000000000", "1e300", "0.1", "18446744073709551616000"}) {
        EXPECT_TRUE(lex(text).messages.empty()) << text;
    }
}

TEST(Lexer, Strings) {
    EXPECT_EQ(string(R"("")"), "");
    EXPECT_EQ(string(R"("a\"b\\c\td\ne\rf")"), "a\"b\\c\td\ne\rf");
    EXPECT_EQ(string(R"("\x41\x7f\u2698\U01F638")"), "A\x7f\u2698\U0001F638");
    EXPECT_EQ(string("\"\xE2\x9A\x98\""), "\u2698");
    EXPECT_EQ(string("\"// /* \""), "// /* ");
    EXPECT_EQ(string("\"a\nb\r\nc\""), "abc");  // Line ends fall away, as in OpenSCAD.
    EXPECT_EQ(string(R"("\x00\u0000\UFFFFFF\ud800")"), "    ");
}

TEST(Lexer, UnknownEscapesAreWarnings) {
    for (const auto& [text, expected] : {std::pair(R"("\q")", "q"), std::pair(R"("\x80")", "x80"),
                                         std::pair(R"("\u12")", "u12"), std::pair(R"("\'")", "'")}) {
        EXPECT_EQ(string(text), expected);
        const Lexed lexed = lex(text);
        ASSERT_EQ(lexed.messages.size(), 1U) << text;
        EXPECT_EQ(lexed.messages[0].text, "Undefined escape sequence");
        EXPECT_EQ(lexed.messages[0].where, (SourceRange{0, 1, 2, 1, 4}));
    }
}

TEST(Lexer, CommentsAndBlanks) {
    EXPECT_EQ(tokens("a// b\nc"), "'a' 'c'");
    EXPECT_EQ(tokens("a// b\rc\nd"), "'a' 'd'");
    EXPECT_EQ(tokens("a/* b /* c */d"), "'a' 'd'");  // They do not nest.
    EXPECT_EQ(tokens("a/**/b/***/c"), "'a' 'b' 'c'");
    EXPECT_EQ(tokens("a //"), "'a'");
    EXPECT_EQ(tokens("a\t\v\f\r\nb\xC2\xA0"
                     "c\xA0"
                     "d\xEF\xBB\xBF"
                     "e"),
              "'a' 'b' 'c' 'd' 'e'");
}

TEST(Lexer, WhatIsNoTokenIsAnErrorThatStays) {
    EXPECT_EQ(tokens("a @ b"), "'a' error:unexpected character '@'");
    EXPECT_EQ(tokens("\x01"), "error:unexpected character byte 0x01");
    EXPECT_EQ(tokens("\xE2\x80\x9Cx"), "error:unexpected character U+201C \u201C");
    EXPECT_EQ(tokens("\"abc"), "error:unterminated string: expected '\"' before the end of the file");
    EXPECT_EQ(tokens("\"abc\\"), "error:unterminated string: expected '\"' before the end of the file");
    EXPECT_EQ(tokens("a /* b *"), "'a' error:unterminated comment: expected '*/' before the end of the file");
    SymbolTable symbols;
    const MessageSink none;
    Lexer lexer("@ a", 0, symbols, none);
    EXPECT_EQ(lexer.take().kind, TokenKind::Error);
    EXPECT_EQ(lexer.take().kind, TokenKind::Error);
}

TEST(Lexer, PlacesCountBytesAndEveryKindOfLineEnd) {
    const Lexed lexed = lex("a\r\nbc\rd\n\n \xC3\xA4 ");
    ASSERT_EQ(lexed.tokens.size(), 4U);
    EXPECT_EQ(lexed.tokens[0].where, (SourceRange{0, 1, 1, 1, 2}));
    EXPECT_EQ(lexed.tokens[1].where, (SourceRange{0, 2, 1, 2, 3}));
    EXPECT_EQ(lexed.tokens[2].where, (SourceRange{0, 3, 1, 3, 2}));
    EXPECT_EQ(lexed.tokens[3].where, (SourceRange{0, 5, 2, 5, 4}));
    const Lexed multiline = lex("\"a\nb\" c");
    EXPECT_EQ(multiline.tokens[0].where, (SourceRange{0, 1, 1, 2, 3}));
    EXPECT_EQ(multiline.tokens[1].where, (SourceRange{0, 2, 4, 2, 5}));
}

TEST(Lexer, FileNames) {
    EXPECT_EQ(tokens("include <a b.scad> use<c>"), "include:a b.scad use:c");
    EXPECT_EQ(tokens("use <>"), "use:");
    EXPECT_EQ(tokens("include\n<a>"), "include:a");
    EXPECT_EQ(tokens("include <a"), "error:expected '>' to close the '<' of this include, found the end of the file");
    EXPECT_EQ(tokens("use = 1"), "'use' = #1.000000");
}

TEST(Lexer, FileNamesOverSeveralLinesAreWarnings) {
    const Lexed lexed = lex("include < a\nb\n>");
    ASSERT_EQ(lexed.tokens.size(), 1U);
    EXPECT_EQ(lexed.symbols.text(lexed.tokens[0].name), "b");
    EXPECT_EQ(lexed.tokens[0].where.line, 3U);
    ASSERT_EQ(lexed.messages.size(), 2U);
    EXPECT_EQ(lexed.messages[1].where.line, 3U);
    EXPECT_EQ(lex("use <a\nb>").messages.size(), 1U);
}

}  // namespace
