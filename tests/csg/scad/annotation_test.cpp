// What comments say about parameters. The expected texts are what OpenSCAD 2021.01 prints.
#include <gtest/gtest.h>

#include "csg/scad/customizer/annotations.h"
#include "csg/scad/text/ast_text.h"
#include "tests/csg/scad/parsing.h"

namespace {

std::string form(const std::string& comment) {
    return csg::scad::comment_value_text(csg::scad::parse_parameter_comment(comment));
}

TEST(ParameterComment, EveryForm) {
    const std::pair<const char*, const char*> cases[] = {
        {"", "\"\""},
        {"  \t", "\"\""},
        {"12", "12"},
        {"  -0.5 ", "-0.5"},
        {"+5", "5"},
        {"1e5", "100000"},
        {"1e", "\"1e\""},
        {"1.2.3", "\"1.2.3\""},
        {"inf", "\"inf\""},
        {"- 5", "\"- 5\""},
        {"5 5", "\"\""},
        {"5 5 a", "\"5 5 a\""},
        {"a  b", "\"a b\""},
        {"a\"b\"c", "\"a b c\""},
        {"comment with \"", "\"comment with \""},
        {"\"a\\\"b\"", "\"a\\\"b\""},
        {"(5)", "5"},
        {"()", "\"\""},
        {"a,b", "\"\""},
        {"a:b", "\"\""},
        {"a[b]", "\"\""},
        {"[]", "\"\""},
        {"[1:12 ", "\"\""},
        {"[1 12]", "\"\""},
        {"[1:12] x", "\"\""},
        {"[12]", "[12]"},
        {"[1:12]", "[1 : 12]"},
        {"[ 1 : 2 : 12 ]", "[1 : 2 : 12]"},
        {"[1:2:3:4]", "\"\""},
        {"[1:2:3,4]", "\"\""},
        {"[1:]", "\"\""},
        {"[,1]", "\"\""},
        {"[1,2,]", "\"\""},
        {"[[1]]", "\"\""},
        {"[1:2,3:4]", "[[1, 2], [3, 4]]"},
        {"[0, 1, 2]", "[0, 1, 2]"},
        {"[foo, bar b]", "[\"foo\", \"bar b\"]"},
        {"[10:Small, 20: 34 Medium, 30:Large 12]", "[[10, \"Small\"], [20, \"34 Medium\"], [30, \"Large 12\"]]"},
        {"[S:Small, M:2]", "[[\"S\", \"Small\"], [\"M\", 2]]"},
        {"[x :1]", "[[\"x\", 1]]"},
        {"[a:b:c]", "\"\""},
        {"[1:\"6\"]", "[[1, \"6\"]]"},
        {"[ \"x, y\" ,z]", "[\"x, y\", \"z\"]"},
    };
    for (const auto& [comment, expected] : cases) {
        EXPECT_EQ(form(comment), expected) << comment;
    }
}

std::string ast(const std::string& text) {
    const csg::scad::Parsed parsed = test::parse(text);
    EXPECT_TRUE(parsed.ok) << text;
    return ast_text(parsed.program);
}

TEST(Annotations, DescriptionStandsOnTheLineAbove) {
    EXPECT_EQ(ast("// d1\n// d2\na=1;"), "//Description(\"d2\")\n//Parameter(\"\")\na = 1;\n");
    EXPECT_EQ(ast("// d\n\na=1;"), "//Parameter(\"\")\na = 1;\n");
    EXPECT_EQ(ast(" // d\na=1;"), "//Parameter(\"\")\na = 1;\n");
    EXPECT_EQ(ast("//a // b//// c ///d\na=1;"), "//Description(\"a   b   c  /d\")\n//Parameter(\"\")\na = 1;\n");
}

TEST(Annotations, FormStandsBehindTheOnlyStatementOfTheLine) {
    EXPECT_EQ(ast("a=\"x;y\"; /* q */ // 5"), "//Parameter(5)\na = \"x;y\";\n");
    EXPECT_EQ(ast("a=\"//x\";"), "//Parameter(\"\")\na = \"//x\";\n");
    EXPECT_EQ(ast("a=1 // 5\n;"), "//Parameter(5)\na = 1;\n");
    EXPECT_EQ(ast("a=1; b=2; // 5"), "//Parameter(\"\")\na = 1;\n//Parameter(\"\")\nb = 2;\n");
    EXPECT_EQ(ast("a=[\n1]; // 5"), "//Parameter(\"\")\na = [1];\n");
}

TEST(Annotations, GroupsCountFromTheNextLineOn) {
    EXPECT_EQ(ast("/*[x]*/ a=1;\nb=2;"), "//Parameter(\"\")\na = 1;\n//Group(\"x\")\n//Parameter(\"\")\nb = 2;\n");
    EXPECT_EQ(ast("/* [a] x [b] */\na=1;"), "//Group(\"a-b\")\n//Parameter(\"\")\na = 1;\n");
    EXPECT_EQ(ast("/* 7 */\na=1;"), "//Group(\"\")\n//Parameter(\"\")\na = 1;\n");
    EXPECT_EQ(ast("/*\n[a]\n*/\na=1;"), "//Parameter(\"\")\na = 1;\n");
    EXPECT_EQ(ast("b=\"/*[a]*/\";\na=1; // /*[q]*/\nc=2;").find("Group"), std::string::npos);
}

TEST(Annotations, ParametersAreLiteralsAboveTheFirstBrace) {
    EXPECT_EQ(ast("a=1; // {\n/* { */\ncube(){}\nb=2;"), "//Parameter(\"{\")\na = 1;\nb = 2;\ncube();\n");
    EXPECT_EQ(ast("a=\"{\";"), "a = \"{\";\n");
    EXPECT_EQ(ast("a=[1,[\"x\",[1:2]],-true];"), "//Parameter(\"\")\na = [1, [\"x\", [1 : 2]], -true];\n");
    for (const char* source : {"a = b;\n", "a = (1 + 2);\n", "a = [b];\n", "a = [each ([1])];\n", "a = f();\n"}) {
        EXPECT_EQ(ast(source), source);
    }
}

TEST(Annotations, OnlyTheMainFileHasParameters) {
    const csg::scad::Parsed parsed =
        test::parse("include <b.scad>\na = 1;\nb = 2;\n", {{"b.scad", "b = 1;\nc = 3;\n"}}, {"a=4"});
    EXPECT_EQ(ast_text(parsed.program), "//Parameter(\"\")\nb = 2;\nc = 3;\n//Parameter(\"\")\na = 4;\n");
}

}  // namespace
