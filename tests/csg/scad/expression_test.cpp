// How expressions are understood: precedence, grouping, every construct.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/csg/scad/parsing.h"

namespace {

using test::value;

/// Binary operators that group to the left, by precedence from the loosest to the tightest.
const std::vector<std::vector<std::string>> kLevels = {
    {"||"}, {"&&"}, {"==", "!="}, {"<", "<=", ">", ">="}, {"|"}, {"&"}, {"<<", ">>"}, {"+", "-"}, {"*", "/", "%"}};

TEST(Precedence, EveryPairOfBinaryOperators) {
    for (std::size_t i = 0; i < kLevels.size(); ++i) {
        for (std::size_t k = 0; k < kLevels.size(); ++k) {
            for (const std::string& p : kLevels[i]) {
                for (const std::string& q : kLevels[k]) {
                    const std::string left = fmt::format("((a {} b) {} c)", p, q);
                    const std::string right = fmt::format("(a {} (b {} c))", p, q);
                    EXPECT_EQ(value(fmt::format("a {} b {} c", p, q)), i < k ? right : left);
                }
            }
        }
    }
}

TEST(Precedence, PowerBindsTightestAndGroupsToTheRight) {
    for (const auto& level : kLevels) {
        for (const std::string& op : level) {
            EXPECT_EQ(value(fmt::format("a {} b ^ c", op)), fmt::format("(a {} (b ^ c))", op));
            EXPECT_EQ(value(fmt::format("a ^ b {} c", op)), fmt::format("((a ^ b) {} c)", op));
        }
    }
    EXPECT_EQ(value("a ^ b ^ c"), "(a ^ (b ^ c))");
    EXPECT_EQ(value("(a ^ b) ^ c"), "((a ^ b) ^ c)");
    EXPECT_EQ(value("-2 ^ 2"), "-(2 ^ 2)");
    EXPECT_EQ(value("(-2) ^ 2"), "(-2 ^ 2)");
    EXPECT_EQ(value("2 ^ -2"), "(2 ^ -2)");
    EXPECT_EQ(value("16 ^ -2 ^ -2"), "(16 ^ -(2 ^ -2))");
    EXPECT_EQ(value("!a ^ b"), "!(a ^ b)");
    EXPECT_EQ(value("a.x ^ b[0]"), "(a.x ^ b[0])");
}

TEST(Precedence, SignsBindTighterThanBinaryOperators) {
    for (const char* sign : {"-", "!", "~"}) {
        for (const auto& level : kLevels) {
            for (const std::string& op : level) {
                EXPECT_EQ(value(fmt::format("{0}a {1} {0}b", sign, op)), fmt::format("({0}a {1} {0}b)", sign, op));
            }
        }
        EXPECT_EQ(value(fmt::format("{}a.b[c](d)", sign)), fmt::format("{}(a.b[c])(d)", sign));
    }
    EXPECT_EQ(value("!-~a"), "!-~a");
}

TEST(Precedence, SignsOfNumbersAreLiterals) {
    EXPECT_EQ(value("4---3"), "(4 - 3)");
    EXPECT_EQ(value("- -3"), "3");
    EXPECT_EQ(value("+a"), "a");
    EXPECT_EQ(value("-+-3"), "3");
    EXPECT_EQ(value("-\"a\""), "-\"a\"");
    EXPECT_EQ(value("-(a)"), "-a");
}

TEST(Precedence, ConditionalsAreLoosestAndGroupToTheRight) {
    for (const auto& level : kLevels) {
        for (const std::string& op : level) {
            EXPECT_EQ(value(fmt::format("a {0} b ? c {0} d : e {0} f", op)),
                      fmt::format("((a {0} b) ? (c {0} d) : (e {0} f))", op));
        }
    }
    EXPECT_EQ(value("a ? b : c ? d : e"), "(a ? b : (c ? d : e))");
    EXPECT_EQ(value("a ? b ? c : d : e"), "(a ? (b ? c : d) : e)");
    EXPECT_EQ(value("(a ? b : c) ? d : e"), "((a ? b : c) ? d : e)");
    EXPECT_EQ(value("a ? let(b = 1) b : function(c) c ? d : e"), "(a ? let(b = 1) b : function(c) (c ? d : e))");
}

TEST(Expressions, EveryForm) {
    // Source, and its normal form where that differs.
    const std::pair<const char*, const char*> cases[] = {
        {"undef", ""},
        {"true", ""},
        {"false", ""},
        {"\"a\\\"b\\n\"", ""},
        {"$fn", ""},
        {"(((a)))", "a"},
        {"[]", ""},
        {"[1,]", "[1]"},
        {"[,]", "[]"},
        {"f(,1,,a=2,)", "f(1, a = 2)"},
        {"function(,a,,b)a", "function(a, b) a"},
        {"[1,,2,,]", "[1, 2]"},
        {"[1,[2,[3]]]", "[1, [2, [3]]]"},
        {"[a:b]", "[a : b]"},
        {"[a:b:c]", "[a : b : c]"},
        {"[a?b:c:d]", "[(a ? b : c) : d]"},
        {"[-1:-0.5:-2]", "[-1 : -0.5 : -2]"},
        {"f()", ""},
        {"f(1,a=2,)", "f(1, a = 2)"},
        {"f(a==b)", "f((a == b))"},
        {"f()()", "(f())()"},
        {"f()[0].x(1)", "(f()[0].x)(1)"},
        {"(f)(1)", "f(1)"},
        {"(function(x) x)(2)", "(function(x) x)(2)"},
        {"a[b+c]", "a[(b + c)]"},
        {"[1,2][0]", "[1, 2][0]"},
        {"\"a\"[0]", ""},
        {"a.b.c", ""},
        {"let() a", ""},
        {"let(a=1,b=a,) a+b", "let(a = 1, b = a) (a + b)"},
        {"let(1) a", ""},
        {"assert(a)", ""},
        {"assert(a, \"m\") b+c", "assert(a, \"m\") (b + c)"},
        {"assert(a)[0]", "assert(a) [0]"},
        {"assert(a)-1", "assert(a) -1"},
        {"echo()", ""},
        {"echo(1,a=2)echo()3", "echo(1, a = 2) echo() 3"},
        {"function() 1", ""},
        {"function(a,b=2,)a+b", "function(a, b = 2) (a + b)"},
        {"function(a)function(b)a", "function(a) function(b) a"},
        {"[for(i=[1:3])i]", "[for(i = [1 : 3]) (i)]"},
        {"[for(i=a,j=b)[i,j]]", "[for(i = a, j = b) ([i, j])]"},
        {"[for(i=0;i<3;i=i+1)i]", "[for(i = 0;(i < 3);i = (i + 1)) i]"},
        {"[for(i=0,j=1;i<3;i=i+1,j=j*2,)[i,j]]", "[for(i = 0, j = 1;(i < 3);i = (i + 1), j = (j * 2)) [i, j]]"},
        {"[for(;a;)1]", "[for(;a;) 1]"},
        {"[if(a)b]", "[if(a) (b)]"},
        {"[if(a)b else c]", "[if(a) (b) else (c)]"},
        {"[if(a)if(b)c else d]", "[if(a) (if(b) (c) else (d))]"},
        {"[if(a)(if(b)c)else d]", "[if(a) (if(b) (c)) else (d)]"},
        {"[let(a=1)a]", "[let(a = 1) a]"},
        {"[let(a=1)for(i=a)i]", "[let(a = 1) (for(i = a) (i))]"},
        {"[let(a=1)(for(i=a)i)]", "[let(a = 1) (for(i = a) (i))]"},
        {"[let(a=1)let(b=2)if(a)b]", "[let(a = 1) (let(b = 2) (if(a) (b)))]"},
        {"[(let(a=1)a)+2]", "[(let(a = 1) a + 2)]"},
        {"[each a]", "[each (a)]"},
        {"[each for(i=a)i, each [1], 2]", "[each (for(i = a) (i)), each ([1]), 2]"},
        {"[1, for(i=a)i, (if(b)c), (1)+2]", "[1, for(i = a) (i), if(b) (c), (1 + 2)]"},
        {"[for(i=a)let(b=i)if(b)each b else i]", "[for(i = a) (let(b = i) (if(b) (each (b)) else (i)))]"},
        {"[for(i=[0:2])assert(i)i]", "[for(i = [0 : 2]) (assert(i) i)]"},
        {"0xff", "255"},
        {"1e6", "1e+6"},
    };
    for (const auto& [source, expected] : cases) {
        EXPECT_EQ(value(source), *expected == 0 ? source : expected) << source;
    }
}

TEST(Expressions, NormalFormIsStable) {
    for (const char* source : {"a?b:c", "-(a+b)^c", "[for(i=0;i<3;i=i+1)i]", "f(a)(b)[c].d",
                               "let(a=1)assert(a)echo(a)a", "[each if(a)b else c]", "function(x,y=[1:2:3])x|y&~1<<2"}) {
        const std::string once = value(source);
        EXPECT_EQ(value(once), once);
    }
}

TEST(Expressions, ChildrenComeBeforeParents) {
    const csg::scad::Parsed parsed = test::parse(
        "x = [for(i=[0:1:2], j=f(i)(2)[3].y) if (i) let(a=1) each a ? b : c ? d : e else -i ^ 2];"
        "y = [for(i=0;i<1;i=i+1) i]; z = function(a, b=2) assert(a) echo(b) a;");
    ASSERT_TRUE(parsed.ok) << test::messages(parsed);
    const csg::scad::Program& p = parsed.program;
    for (csg::scad::ExprId id = 0; id < p.expressions.size(); ++id) {
        const csg::scad::Expr& e = p[id];
        for (const csg::scad::ExprId operand : e.operands) {
            EXPECT_TRUE(operand == csg::scad::kNone || operand < id);
        }
        if (e.kind == csg::scad::ExprKind::Vector) {
            for (const csg::scad::ExprId element : p.elements_of(e)) {
                EXPECT_LT(element, id);
            }
            continue;
        }
        if (e.kind == csg::scad::ExprKind::Number || e.kind == csg::scad::ExprKind::Boolean) {
            continue;  // What these hold lies where others have their arguments.
        }
        for (const auto& arguments : {p.arguments_of(e), p.update_of(e)}) {
            for (const csg::scad::Argument& a : arguments) {
                EXPECT_TRUE(a.value == csg::scad::kNone || a.value < id);
            }
        }
        EXPECT_TRUE(e.where.known());
    }
}

TEST(Expressions, RangesOfSource) {
    const csg::scad::Parsed parsed = test::parse("x = a + f(1,\n 2)[3] * -b.c;");
    ASSERT_TRUE(parsed.ok);
    const csg::scad::Program& p = parsed.program;
    using csg::scad::ExprKind;
    using csg::scad::SourceRange;
    std::map<ExprKind, SourceRange> last;
    for (const csg::scad::Expr& e : p.expressions) {
        last[e.kind] = e.where;
    }
    EXPECT_EQ(last[ExprKind::Binary], (SourceRange{0, 1, 5, 2, 14}));
    EXPECT_EQ(last[ExprKind::Call], (SourceRange{0, 1, 9, 2, 4}));
    EXPECT_EQ(last[ExprKind::Index], (SourceRange{0, 1, 9, 2, 7}));
    EXPECT_EQ(last[ExprKind::Unary], (SourceRange{0, 2, 10, 2, 14}));
    EXPECT_EQ(last[ExprKind::Member], (SourceRange{0, 2, 11, 2, 14}));
    EXPECT_EQ(p.assignments[0].where, (SourceRange{0, 1, 1, 2, 14}));
}

}  // namespace
