// Whatever the text, parsing ends soon, without a crash, and says whether it went well.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <span>
#include <string_view>

#include "csg/scad/text/ast_text.h"
#include "csg/scad/text/expression_text.h"
#include "tests/csg/scad/build_bodies.h"
#include "tests/csg/scad/parsing.h"

namespace {

namespace fs = std::filesystem;
using csg::scad::Parsed;

std::vector<std::string> sources() {
    std::vector<std::string> all;
    for (const char* folder :
         {"models", "tests/ui/command_line/bad", "tests/csg/scad/golden", "tests/bench/language"}) {
        for (const auto& entry : fs::directory_iterator(fs::path(CSGSCOPE_SOURCE_DIR) / folder)) {
            if (entry.path().extension() == ".scad") {
                all.push_back(test::read_file(entry.path().string()));
            }
        }
    }
    return all;
}

/// Whether children are nothing but an assignment. OpenSCAD prints these without the braces that they need.
bool has_lone_assignment(const csg::scad::Program& p) {
    return std::any_of(p.instantiations.begin(), p.instantiations.end(), [&](const auto& i) {
        for (const csg::scad::BlockId id : {i.children, i.otherwise}) {
            if (id == csg::scad::kNone || p.blocks[id].assignments.count != 1) {
                continue;
            }
            const auto others = p.instantiations_of(p.blocks[id]);
            if (std::all_of(others.begin(), others.end(), [](const auto& o) { return o.modifiers.disabled; })) {
                return true;
            }
        }
        return false;
    });
}

/// Where a definition is and what its parameters are, of those at the top of the main file.
template <typename Definition>
std::string places(const csg::scad::Program& p, std::span<const Definition> definitions) {
    std::string all;
    for (const Definition& d : definitions) {
        all += fmt::format("{}({}) {}:{}-{}:{}\n", p.symbols.text(d.name), d.parameters.count, d.where.line,
                           d.where.column, d.where.end_line, d.where.end_column);
    }
    return all;
}

std::string places(const csg::scad::Program& p) {
    const csg::scad::Block& block = p.blocks[p.units[0].block];
    return places(p, p.functions_of(block)) + places(p, p.modules_of(block));
}

/// Bodies that are built later make the same tree, and nothing is said later than it would have been.
void check_lazy(const std::string& text, const test::Files& files, const Parsed& parsed) {
    Parsed lazy = test::parse_lazily(text, files);
    ASSERT_EQ(lazy.ok, parsed.ok);
    ASSERT_EQ(test::messages(lazy), test::messages(parsed));
    if (lazy.ok) {
        ASSERT_EQ(places(lazy.program), places(parsed.program));
        const auto* const before = lazy.program.expressions.data();
        test::build_bodies(lazy.program);
        ASSERT_EQ(lazy.program.expressions.data(), before);
        ASSERT_EQ(ast_text(lazy.program), ast_text(parsed.program));
    }
}

/// Parses with the text itself as the only other file, and checks what every result promises.
void check(const std::string& text) {
    const test::Files files{{"shapes.scad", text}, {"stray_brace.scad", text}};
    const Parsed parsed = test::parse(text, files);
    ASSERT_NO_FATAL_FAILURE(check_lazy(text, files, parsed));
    const auto errors = std::count_if(parsed.messages.begin(), parsed.messages.end(), [](const auto& message) {
        return message.severity == csg::scad::Severity::Error;
    });
    ASSERT_EQ(parsed.ok, parsed.program.units[0].block != csg::scad::kNone);
    ASSERT_TRUE(parsed.ok || errors == 1);
    for (const auto& message : parsed.messages) {
        ASSERT_TRUE(message.where.known());
        ASSERT_FALSE(render(message, parsed.program.sources).empty());
    }
    if (parsed.ok && !has_lone_assignment(parsed.program)) {  // The normal form parses, and is its own normal form.
        const std::string normal = ast_text(parsed.program);
        const Parsed again = test::parse(normal);
        ASSERT_TRUE(again.ok) << test::messages(again);
        ASSERT_EQ(test::without_comments(ast_text(again.program)), test::without_comments(normal));
    }
}

TEST(Robustness, EveryPrefixOfEveryFile) {
    for (const std::string& text : sources()) {
        const std::size_t step = 1 + text.size() / 600;
        for (std::size_t length = 0; length <= text.size(); length += step) {
            check(text.substr(0, length));
        }
    }
}

TEST(Robustness, MutatedFiles) {
    const std::vector<std::string> all = sources();
    static constexpr char kOdd[] =
        "(){}[]<>;:,.?!#%*&|~^=+-/\\\"'$ \n\r\t\0\x01\xC3\xA0\xFF"
        "e0x1";
    constexpr std::string_view odd(kOdd, sizeof kOdd - 1);
    EXPECT_TRUE(rc::check("texts with a few changes", [&] {
        std::string text = *rc::gen::elementOf(all);
        const auto changes = *rc::gen::inRange<std::size_t>(1, 8);
        for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
            const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
            switch (*rc::gen::inRange(0, 4)) {
                case 0:
                    text.erase(at, *rc::gen::inRange<std::size_t>(1, 20));
                    break;
                case 1:
                    text.insert(at, 1, odd[*rc::gen::inRange<std::size_t>(0, odd.size())]);
                    break;
                case 2:
                    text[at] = odd[*rc::gen::inRange<std::size_t>(0, odd.size())];
                    break;
                default:
                    text.insert(at, text.substr(*rc::gen::inRange<std::size_t>(0, text.size()), 30));
            }
        }
        check(text);
        RC_ASSERT(!testing::Test::HasFatalFailure());
    }));
}

TEST(Robustness, ArbitraryBytes) {
    EXPECT_TRUE(rc::check("bytes", [] {
        check(*rc::gen::arbitrary<std::string>());
        RC_ASSERT(!testing::Test::HasFatalFailure());
    }));
}

std::string repeated(std::string_view text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i) {
        all += text;
    }
    return all;
}

constexpr std::size_t kMany = 300'000;

/// Generous: what is measured is that the time grows with the length, not with its square.
constexpr std::chrono::seconds kSoon{20};

class LongChain : public testing::TestWithParam<std::pair<const char*, std::string>> {};

TEST_P(LongChain, ParsesAndPrints) {
    const auto begin = std::chrono::steady_clock::now();
    const Parsed parsed = test::parse(GetParam().second);
    ASSERT_TRUE(parsed.ok) << parsed.messages.back().text;
    EXPECT_GT(ast_text(parsed.program).size(), kMany);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, kSoon);
}

INSTANTIATE_TEST_SUITE_P(Robustness, LongChain,
                         testing::Values(std::pair("Sum", "x = " + repeated("1 + ", kMany) + "1;"),
                                         std::pair("Product", "x = " + repeated("a * b + ", kMany) + "1;"),
                                         std::pair("Conditional", "x = " + repeated("a ? b : ", kMany) + "c;"),
                                         std::pair("Calls", "x = f" + repeated("(1)", kMany) + ";"),
                                         std::pair("Indices", "x = a" + repeated("[0]", kMany) + ";"),
                                         std::pair("Members", "x = a" + repeated(".x", kMany) + ";"),
                                         std::pair("Vector", "x = [" + repeated("1,", kMany) + "];"),
                                         std::pair("Arguments", "f(" + repeated("1,", kMany) + ");"),
                                         std::pair("ElseIf", repeated("if (a) b(); else ", kMany) + "c();"),
                                         std::pair("Statements", repeated("a();", kMany)),
                                         std::pair("Definitions", repeated("function f() = 1;", kMany))),
                         [](const auto& info) { return info.param.first; });

class DeepNesting : public testing::TestWithParam<std::pair<const char*, std::array<std::string, 4>>> {};

/// The most that is allowed parses and prints; one million levels are an error, at once.
TEST_P(DeepNesting, IsBounded) {
    const std::array<std::string, 4>& parts = GetParam().second;  // Before, opening, middle, closing.
    const auto text = [&](std::size_t levels) {
        return parts[0] + repeated(parts[1], levels) + parts[2] + repeated(parts[3], levels) + ";";
    };
    constexpr std::size_t kAllowed = csg::scad::kMaxNesting - 5;
    const Parsed deep = test::parse(text(kAllowed));
    EXPECT_TRUE(deep.ok) << deep.messages.back().text;
    EXPECT_FALSE(ast_text(deep.program).empty());
    const auto begin = std::chrono::steady_clock::now();
    const Parsed deeper = test::parse(text(1'000'000));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, kSoon);
    EXPECT_FALSE(deeper.ok);
    ASSERT_EQ(deeper.messages.size(), 1U);
    EXPECT_EQ(deeper.messages[0].text, "nested deeper than 1000 levels");
    EXPECT_EQ(deeper.messages[0].where.line, 1U);
}

using Nested = std::array<std::string, 4>;
INSTANTIATE_TEST_SUITE_P(Robustness, DeepNesting,
                         testing::Values(std::pair("Parentheses", Nested{"x = ", "(", "1", ")"}),
                                         std::pair("Vectors", Nested{"x = ", "[", "1", "]"}),
                                         std::pair("Signs", Nested{"x = ", "-", "a;", ""}),
                                         std::pair("Powers", Nested{"x = ", "2 ^ ", "a;", ""}),
                                         std::pair("Lets", Nested{"x = ", "let(a = 1) ", "a;", ""}),
                                         std::pair("Functions", Nested{"x = ", "function(a) ", "a;", ""}),
                                         std::pair("Asserts", Nested{"x = ", "assert(a) ", "a;", ""}),
                                         std::pair("Indices", Nested{"x = ", "a[", "1", "]"}),
                                         std::pair("Arguments", Nested{"x = ", "f(", "1", ")"}),
                                         std::pair("Loops", Nested{"x = [", "for (a = b) ", "a];", ""}),
                                         std::pair("Choices", Nested{"x = ", "a ? ", "1", " : 2"}),
                                         std::pair("Children", Nested{"", "a() ", ";", ""}),
                                         std::pair("Ifs", Nested{"", "if (a) ", ";", ""}),
                                         std::pair("Modules", Nested{"", "module m() ", "x = 1;", ""}),
                                         std::pair("Groups", Nested{"", "{", "a();", "}"})),
                         [](const auto& info) { return info.param.first; });

/// Every level of precedence in every pair of parentheses: the deepest tree for its nesting.
TEST(Robustness, TheDeepestTree) {
    const std::string open = "1 || 1 && 1 == 1 < 1 | 1 & 1 << 1 + 1 * (";
    const std::string text = "x = " + repeated(open, 900) + "1" + repeated(")", 900) + ";";
    const Parsed parsed = test::parse(text);
    ASSERT_TRUE(parsed.ok) << parsed.messages.back().text;
    EXPECT_GT(ast_text(parsed.program).size(), text.size());
}

}  // namespace
