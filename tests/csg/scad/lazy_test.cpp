// Bodies of definitions that are not built before somebody asks.
#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "csg/scad/text/ast_text.h"
#include "tests/csg/scad/build_bodies.h"
#include "tests/csg/scad/parsing.h"

namespace {

using csg::scad::kNone;
using csg::scad::Parsed;
using csg::scad::Program;

/// How many definitions of the main file have no body yet.
std::size_t unbuilt(const Parsed& parsed) {
    const Program& p = parsed.program;
    std::size_t count = 0;
    for (const auto& f : p.functions) {
        count += f.body == kNone;
    }
    for (const auto& m : p.modules) {
        count += m.body == kNone;
    }
    return count;
}

class Lazy : public testing::TestWithParam<const char*> {};
class Eager : public testing::TestWithParam<const char*> {};

void expect_same_tree(const std::string& text, Parsed& lazy) {
    const Parsed parsed = test::parse(text);
    ASSERT_TRUE(parsed.ok) << test::messages(parsed);
    ASSERT_TRUE(lazy.ok);
    EXPECT_EQ(test::messages(lazy), test::messages(parsed));
    test::build_bodies(lazy.program);
    EXPECT_EQ(unbuilt(lazy), 0U);
    EXPECT_EQ(ast_text(lazy.program), ast_text(parsed.program));
}

TEST_P(Lazy, BodyIsBuiltWhenAskedFor) {
    Parsed lazy = test::parse_lazily(GetParam());
    EXPECT_EQ(unbuilt(lazy), 1U);
    expect_same_tree(GetParam(), lazy);
}

INSTANTIATE_TEST_SUITE_P(
    Parser, Lazy,
    testing::Values("function f(x = [1, 2]) = x;", "function f() = a ? b : c ? -d ^ -e : f(1, , x = 2, );",
                    "function f() = [for (i = [0:2:10]) if (i != 3) let (j = i) each [i, j] else i];",
                    "function f() = [for (i = 0, j = 1; i < 3; i = i + 1, j = j * 2) (each [i, j])];",
                    "function f() = let (a = 1e5, b = .5, c = 1.) assert(a > b, \"x\\n\") echo(a) a.x[2](3).y && !b;",
                    "function f() = function (x, $fn = 3) x == 2 || x << 1 >= ~3 ? undef : true;",
                    "function f() = [,] == [1, 2, ,] /* a ; in a comment */ // and }\r\n + [[0:1], \";\"][0];",
                    "function f() = [if (a) assert(b) else echo(c)];", "function f() = include + use;",
                    "module m(a, b = 2) { c = 1; cube(a); function g(x) = x; module n() sphere(); ; { d = 2; } }",
                    "module m() { if (a) b(); else if (c) { d(); } else #%translate([1, 2]) * cube(); c = 1; }",
                    "module m() for (i = [1:3]) let (j = i) { k = j; assert(k) echo(k); !children(); }",
                    "module m() {}", "module m() if (a) b(); cube();",
                    "module m() union() { a = 1; union() { a = 2; } }"));

TEST_P(Eager, BodyHasTheParsersSay) {
    Parsed lazy = test::parse_lazily(GetParam());
    EXPECT_EQ(unbuilt(lazy), 0U);
    expect_same_tree(GetParam(), lazy);
}

INSTANTIATE_TEST_SUITE_P(Parser, Eager,
                         testing::Values("module m() ;\ncube();",                 // One token, and what follows …
                                         "module m() ;1r = 2;",                   // … is read, and told of, already.
                                         "module m() { a = 1; a = 2; }",          // A warning.
                                         "function f() = 2d;",                    // Deprecated.
                                         "function f() = \"\\q\";",               // A warning.
                                         "function f() = 12345678901234567890;",  // A warning.
                                         "function f() = 0xFFFFFFFFFFFFFFFFFF;",  // A warning.
                                         "function f() = 1e999;",                 // A warning.
                                         "module m() if (a) b();"));              // The including file may go on.

/// Errors are found when the text is read, whether or not anybody calls what they are in.
TEST(LazyBodies, ErrorsAreSaidAtOnce) {
    for (const char* const text :
         {"function f() = [for (i = 2) ;", "module m() { cube() }", "function f() = 1 +;", "module m() { 1; }",
          "function f() = (for (i = 2) i);", "module m() { a = 1; } }", "function f() = a b;", "module m() cube()",
          "function f() = \"abc;", "module m() { /* }", "module m() union() { function g() = 1; }",
          "function f() = -let (a = 1) a;", "module m() { union() a = 1; }", "function f() = a.5;"}) {
        const Parsed lazy = test::parse_lazily(text);
        EXPECT_FALSE(lazy.ok) << text;
        EXPECT_EQ(test::messages(lazy), test::messages(test::parse(text)));
    }
}

TEST(LazyBodies, IncludesInThemAreTaken) {
    const test::Files files{{"rest.scad", "+ 2; x = 3;"}, {"else.scad", "else c();"}};
    for (const char* const text : {"function f() = 1 include <rest.scad>", "module m() { y = 1 include <rest.scad> }",
                                   "module m() if (a) b(); include <else.scad>"}) {
        Parsed lazy = test::parse_lazily(text, files);
        const Parsed parsed = test::parse(text, files);
        ASSERT_TRUE(parsed.ok) << test::messages(parsed);
        EXPECT_EQ(unbuilt(lazy), 0U);
        EXPECT_EQ(ast_text(lazy.program), ast_text(parsed.program));
    }
    const test::Files open{{"a.scad", "module m() if (a) b();"}};
    const std::string text = "include <a.scad> else c();";
    EXPECT_EQ(ast_text(test::parse_lazily(text, open).program), ast_text(test::parse(text, open).program));
}

TEST(LazyBodies, ALibraryIsIncludedTwice) {
    const test::Files files{{"library.scad", "function f(x) = x + 1;\nmodule m() { cube(f(1)); }\n"}};
    const std::string text = "include <library.scad>\ninclude <library.scad>\nm();";
    Parsed lazy = test::parse_lazily(text, files);
    EXPECT_EQ(unbuilt(lazy), 4U);
    test::build_bodies(lazy.program);
    EXPECT_EQ(ast_text(lazy.program), ast_text(test::parse(text, files).program));
}

}  // namespace
