// include and use.
#include <gtest/gtest.h>

#include "csg/scad/syntax/parser_files.h"
#include "tests/csg/scad/parsing.h"

namespace {

using csg::scad::kNone;
using csg::scad::Parsed;
using csg::scad::Unit;
using test::messages;
using test::parse;

std::vector<std::string> module_names(const Parsed& parsed, csg::scad::UnitId unit = 0) {
    std::vector<std::string> names;
    const csg::scad::Program& p = parsed.program;
    for (const auto& i : p.instantiations_of(p.blocks[p.units[unit].block])) {
        names.push_back(p.symbols.text(i.name));
    }
    return names;
}

TEST(Include, PutsTheTextInItsPlace) {
    const Parsed parsed = parse("a(); include <x.scad> b(); include<y/z.scad>; c();",
                                {{"x.scad", "x();"}, {"y/z.scad", "include <w.scad>"}, {"y/w.scad", "w();"}});
    EXPECT_TRUE(parsed.ok);
    EXPECT_EQ(module_names(parsed), (std::vector<std::string>{"a", "x", "b", "w", "c"}));
}

TEST(Include, MayStandAnywhere) {
    const test::Files files{{"number.scad", "40 + "}, {"open.scad", "{ cube();"}};
    const Parsed parsed = parse("x = include <number.scad> 2; union() include <open.scad> sphere(); }", files);
    EXPECT_TRUE(parsed.ok) << messages(parsed);
    EXPECT_EQ(parsed.program.expressions.size(), 3U);
}

TEST(Include, LooksBesideTheFileAndThenInTheSearchPath) {
    const Parsed parsed = parse("include <a.scad> include <b.scad>",
                                {{"a.scad", "here();"}, {"library/a.scad", "there();"}, {"library/b.scad", "b();"}});
    EXPECT_EQ(module_names(parsed), (std::vector<std::string>{"here", "b"}));
}

TEST(Include, AFileIncludedTwiceIsListedOnce) {
    const Parsed parsed = parse("include <a.scad> include <./x/../a.scad> include <a.scad>", {{"a.scad", "a();"}});
    EXPECT_EQ(module_names(parsed).size(), 3U);
    EXPECT_EQ(parsed.program.sources.size(), 2U);
}

TEST(Include, AMissingFileIsAWarning) {
    const Parsed parsed = parse("a();\ninclude <no.scad>\ninclude <dir/>\nb();");
    EXPECT_TRUE(parsed.ok);
    EXPECT_EQ(messages(parsed),
              "main.scad:2:1: warning: Can't find include file 'no.scad'.\n"
              "main.scad:3:1: warning: Can't find include file 'dir/'.\n");
    EXPECT_EQ(module_names(parsed), (std::vector<std::string>{"a", "b"}));
}

TEST(Include, AFileThatCannotBeReadSaysWhy) {
    csg::scad::ParseRequest request;
    request.path = "main.scad";
    request.text = "include <a.scad> use <a.scad>";
    request.search_path.clear();
    request.reader = [](const std::string& path) {
        return csg::scad::ReadError{false, "cannot read " + path + ": it is cursed"};
    };
    EXPECT_EQ(messages(csg::scad::parse(request)),
              "main.scad:1:1: warning: Can't open include file 'a.scad': cannot read a.scad: it is cursed\n"
              "main.scad:1:18: warning: Can't open library 'a.scad': cannot read a.scad: it is cursed\n");
}

TEST(Include, CirclesEnd) {
    const test::Files files{{"main.scad", "include <main.scad> a();"},
                            {"b.scad", "include <c.scad> b();"},
                            {"c.scad", "include <b.scad> c();"}};
    const Parsed self = parse(files.at("main.scad"), files);
    EXPECT_TRUE(self.ok);
    EXPECT_EQ(module_names(self), (std::vector<std::string>{"a", "a"}));  // OpenSCAD, too, goes round once.
    const Parsed two = parse("include <b.scad>", files);
    EXPECT_TRUE(two.ok);
    EXPECT_EQ(module_names(two), (std::vector<std::string>{"c", "b"}));
    EXPECT_EQ(messages(two), "c.scad:1:1: warning: Can't find include file 'b.scad'.\n");
}

/// Files that include each other in every order would be read more often than there are atoms.
TEST(Include, ManyCirclesEndWithAnError) {
    std::string all;
    for (int i = 0; i < 20; ++i) {
        all += "include <" + std::to_string(i) + ">\n";
    }
    test::Files files;
    for (int i = 0; i < 20; ++i) {
        files[std::to_string(i)] = all;
    }
    const Parsed parsed = parse(all, files);
    EXPECT_FALSE(parsed.ok);
    EXPECT_EQ(parsed.messages.back().severity, csg::scad::Severity::Error);
    EXPECT_EQ(parsed.messages.back().text, "included files are more than 10000, or larger than 64 MiB in all");
}

TEST(Include, DepthIsBounded) {
    test::Files files;
    for (int i = 0; i < 200; ++i) {
        files[std::to_string(i)] = "include <" + std::to_string(i + 1) + ">";
    }
    const Parsed parsed = parse("include <0>", files);
    EXPECT_FALSE(parsed.ok);
    EXPECT_EQ(messages(parsed), "99:1:1: error: included files nest deeper than 100 levels\n");
}

TEST(Include, AnErrorInsideIsLocatedThereAndEndsAll) {
    const Parsed parsed = parse("a();\ninclude <b.scad>\nc();", {{"b.scad", "\nb(;\n"}});
    EXPECT_FALSE(parsed.ok);
    EXPECT_EQ(parsed.program.units[0].block, kNone);
    EXPECT_EQ(messages(parsed), "b.scad:2:3: error: expected an expression, found ';'\n");
}

TEST(Include, AMissingSemicolonIsLocatedWhereItIsMissing) {
    EXPECT_EQ(messages(parse("include <b.scad>\nc();", {{"b.scad", "a = 1"}})),
              "b.scad:1:6: error: expected ';' after the assignment, found 'c'\n");
}

TEST(Include, TheMainFileMayReplaceWhatItIncludes) {
    const test::Files files{{"b.scad", "a = 1;"}};
    EXPECT_EQ(messages(parse("include <b.scad>\na = 2;", files)), "");
    EXPECT_EQ(messages(parse("a = 2;\ninclude <b.scad>", files)),
              "b.scad:1:1: warning: \"a\" was assigned on line 1 of \"main.scad\" but was overwritten\n");
}

TEST(Use, MakesUnits) {
    const Parsed parsed = parse("use <a.scad>\nuse <b.scad>;\nm();",
                                {{"a.scad", "use <b.scad>\nmodule m() {} x = 1;"}, {"b.scad", "module n() {}"}});
    EXPECT_TRUE(parsed.ok);
    EXPECT_EQ(messages(parsed), "");
    const std::vector<Unit>& units = parsed.program.units;
    ASSERT_EQ(units.size(), 3U);
    ASSERT_EQ(units[0].uses.size(), 2U);
    EXPECT_EQ(units[0].uses[0].path, "a.scad");
    EXPECT_EQ(units[0].uses[0].unit, 1U);
    EXPECT_EQ(units[0].uses[1].unit, 2U);
    ASSERT_EQ(units[1].uses.size(), 1U);
    EXPECT_EQ(units[1].uses[0].unit, 2U);
    EXPECT_NE(units[2].block, kNone);
}

TEST(Use, GoesRoundInCircles) {
    const test::Files files{{"main.scad", "use <a.scad>"}, {"a.scad", "use <main.scad> use <a.scad>"}};
    const Parsed parsed = parse(files.at("main.scad"), files);
    EXPECT_TRUE(parsed.ok);
    ASSERT_EQ(parsed.program.units.size(), 2U);
    ASSERT_EQ(parsed.program.units[1].uses.size(), 2U);
    EXPECT_EQ(parsed.program.units[1].uses[0].unit, 0U);
    EXPECT_EQ(parsed.program.units[1].uses[1].unit, 1U);
    EXPECT_EQ(parsed.program.sources.size(), 2U);
}

TEST(Use, OfAnIncludedFileCountsForTheIncludingOne) {
    const Parsed parsed = parse("include <d/a.scad>\nuse <d/b.scad>", {{"d/a.scad", "use <b.scad>"}, {"d/b.scad", ""}});
    ASSERT_EQ(parsed.program.units.size(), 2U);
    ASSERT_EQ(parsed.program.units[0].uses.size(), 1U);  // A path used twice is listed once.
    EXPECT_EQ(parsed.program.units[0].uses[0].path, "d/b.scad");
}

TEST(Use, ABrokenFileLeavesTheOthersWhole) {
    const Parsed parsed = parse("use <a.scad>\nb();", {{"a.scad", "module ("}});
    EXPECT_TRUE(parsed.ok);
    EXPECT_EQ(messages(parsed), "a.scad:1:8: error: expected the name of the module, found '('\n");
    EXPECT_EQ(parsed.program.units[0].uses.at(0).unit, kNone);
    EXPECT_EQ(parsed.program.units.at(1).block, kNone);
}

TEST(Use, MissingFilesAndFonts) {
    const Parsed parsed = parse("use <no.scad>\nuse <f.TTF>\nuse <>", {{"f.TTF", "font"}});
    EXPECT_TRUE(parsed.ok);
    EXPECT_EQ(messages(parsed),
              "main.scad:1:1: warning: Can't open library 'no.scad'.\n"
              "main.scad:3:1: warning: Can't open library ''.\n");
    const std::vector<csg::scad::Use>& uses = parsed.program.units[0].uses;
    ASSERT_EQ(uses.size(), 3U);
    EXPECT_TRUE(uses[1].font);
    EXPECT_EQ(uses[1].unit, kNone);
    EXPECT_FALSE(uses[0].font);
    EXPECT_EQ(parsed.program.units.size(), 1U);
}

}  // namespace
