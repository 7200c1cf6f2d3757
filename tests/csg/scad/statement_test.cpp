// Statements, blocks, definitions, instantiations.
#include <gtest/gtest.h>

#include "tests/csg/scad/parsing.h"

namespace {

using test::tree;

TEST(Statements, EveryForm) {
    const std::pair<const char*, const char*> cases[] = {
        {"", ""},
        {";;", ""},
        {"a = 1;", "a = 1;"},
        {"cube();", "cube();"},
        {"cube(1, center = true,);", "cube(1, center = true);"},
        {"for(i = [1:2], j = 3) cube(i);", "for(i = [1 : 2], j = 3) cube(i);"},
        {"let(a = 1) assert(a) echo(a) each() cube();", "let(a = 1) assert(a) echo(a) each() cube();"},
        {"union() { a = 1; cube(a); }", "union() { a = 1; cube(a); }"},
        {"union() {}", "union();"},
        {"union() { ; }", "union();"},
        {"union() { cube(); }", "union() cube();"},
        {"union() { { a = 1; } cube(); }", "union() { a = 1; cube(); }"},
        {"{ a = 1; { cube(); } module m() {} }", "module m() { } a = 1; cube();"},
        {"module m(a, b = 1,) { cube(a); function f() = b; module n() {} }",
         "module m(a, b = 1) { function f() = b; module n() { } cube(a); }"},
        {"module m() cube();", "module m() { cube(); }"},
        {"module m() a = 1;", "module m() { a = 1; }"},
        {"module m();", "module m() { }"},
        {"module m() module n() cube();", "module m() { module n() { cube(); } }"},
        {"function f(a, b = 2,) = a + b;", "function f(a, b = 2) = (a + b);"},
        {"if (a) cube();", "if(a) cube();"},
        {"if (a) cube(); else sphere();", "if(a) cube(); else sphere();"},
        {"if (a) {} else {}", "if(a); else;"},
        {"if (a) if (b) cube(); else sphere();", "if(a) if(b) cube(); else sphere();"},
        {"if (a) cube(); else if (b) sphere(); else if (c) {} else square();",
         "if(a) cube(); else if(b) sphere(); else if(c); else square();"},
        {"if (a) { x = 1; cube(x); }", "if(a) { x = 1; cube(x); }"},
        {"!#%cube();", "cube();"},
        {"*cube();", ""},
        {"union() { *cube(); sphere(); }", "union() sphere();"},
        {"translate([1, 2]) rotate(3) { cube(); sphere(); }", "translate([1, 2]) rotate(3) { cube(); sphere(); }"},
        {"include = 5; use = include;", "include = 5; use = include;"},
        {"\xEF\xBB\xBF"
         "cube();",
         "cube();"},
        {"cube(\r\n);\r\nsphere();\r", "cube(); sphere();"},
    };
    for (const auto& [source, expected] : cases) {
        EXPECT_EQ(tree(source), expected) << source;
    }
}

TEST(Statements, DanglingElseBelongsToTheInnerIf) {
    const csg::scad::Parsed parsed = test::parse("if (a) if (b) cube(); else sphere();");
    const csg::scad::Program& p = parsed.program;
    const auto outer = p.instantiations_of(p.blocks[p.units[0].block]);
    ASSERT_EQ(outer.size(), 1U);
    EXPECT_EQ(outer[0].otherwise, csg::scad::kNone);
    const auto inner = p.instantiations_of(p.blocks[outer[0].children]);
    ASSERT_EQ(inner.size(), 1U);
    EXPECT_NE(inner[0].otherwise, csg::scad::kNone);
    EXPECT_TRUE(inner[0].is_if);
}

TEST(Statements, Modifiers) {
    const csg::scad::Parsed parsed = test::parse("!a(); #b(); %c(); *d(); #%e(); f(); if (x) g(); else !if (y) {}");
    ASSERT_TRUE(parsed.ok);
    const csg::scad::Program& p = parsed.program;
    const auto all = p.instantiations_of(p.blocks[p.units[0].block]);
    ASSERT_EQ(all.size(), 7U);
    EXPECT_TRUE(all[0].modifiers.root && !all[0].modifiers.highlight);
    EXPECT_TRUE(all[1].modifiers.highlight);
    EXPECT_TRUE(all[2].modifiers.background);
    EXPECT_TRUE(all[3].modifiers.disabled);
    EXPECT_TRUE(all[4].modifiers.highlight && all[4].modifiers.background);
    EXPECT_FALSE(all[5].modifiers.root || all[5].modifiers.highlight || all[5].modifiers.background ||
                 all[5].modifiers.disabled);
    EXPECT_FALSE(all[6].modifiers.root);
    EXPECT_TRUE(p.instantiations_of(p.blocks[all[6].otherwise])[0].modifiers.root);
}

TEST(Statements, InstantiationsHaveChildrenAndPlaces) {
    const csg::scad::Parsed parsed = test::parse("a();\n  b(1,\n2) c();");
    const csg::scad::Program& p = parsed.program;
    const auto all = p.instantiations_of(p.blocks[p.units[0].block]);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(p.blocks[all[0].children].instantiations.count, 0U);
    EXPECT_EQ(p.blocks[all[1].children].instantiations.count, 1U);
    EXPECT_EQ(all[1].where, (csg::scad::SourceRange{0, 2, 3, 3, 3}));
}

TEST(Statements, AVariableAssignedTwiceStandsAtItsFirstPlaceWithItsLastValue) {
    const csg::scad::Parsed parsed = test::parse("a = 1;\nb = 2;\na = 3;");
    EXPECT_EQ(test::messages(parsed), "main.scad:3:1: warning: \"a\" was assigned on line 1 but was overwritten\n");
    const csg::scad::Program& p = parsed.program;
    const auto all = p.assignments_of(p.blocks[p.units[0].block]);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(p.symbols.text(all[0].name), "a");
    EXPECT_EQ(p[all[0].value].number, 3);
    EXPECT_EQ(all[0].where.line, 3U);
}

TEST(Statements, EachBlockHasItsOwnVariables) {
    EXPECT_EQ(test::messages(test::parse("a = 1; union() { a = 2; } module m(a) { a = 3; }")), "");
    EXPECT_NE(test::messages(test::parse("a = 1; { a = 2; }")), "");
}

TEST(Statements, DefinitionsOfTheCommandLineComeLast) {
    const csg::scad::Parsed parsed = test::parse("a = 1; b = 2;", {}, {"a=5+x", "c=\"t\";", "d=1;e=2"});
    EXPECT_TRUE(parsed.ok);
    EXPECT_EQ(test::messages(parsed), "");
    const csg::scad::Program& p = parsed.program;
    const auto all = p.assignments_of(p.blocks[p.units[0].block]);
    ASSERT_EQ(all.size(), 5U);
    EXPECT_EQ(p.symbols.text(all[0].name), "a");
    EXPECT_EQ(p.sources[all[0].where.file].name(), "<command line>");
    EXPECT_EQ(p.symbols.text(all[4].name), "e");
}

TEST(Statements, BrokenDefinitionsAreLocatedInTheCommandLine) {
    const std::pair<const char*, const char*> cases[] = {
        {"x=(", "<command line>:1:4: error: expected an expression, found the end of the file\n"},
        {"x", "<command line>:1:1: error: expected name=expression as a definition, found 'x'\n"},
        {"=1", "<command line>:1:1: error: expected name=expression as a definition, found '='\n"},
        {"x=1 2", "<command line>:1:4: error: expected ';' after the definition, found '2'\n"},
        {"cube();", "<command line>:1:1: error: expected name=expression as a definition, found 'cube'\n"},
    };
    for (const auto& [definition, expected] : cases) {
        const csg::scad::Parsed parsed = test::parse("cube();", {}, {definition});
        EXPECT_FALSE(parsed.ok);
        EXPECT_EQ(test::messages(parsed), expected);
    }
}

}  // namespace
