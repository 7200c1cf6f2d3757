// What `evaluate` takes and gives besides the program: definitions, views, files, places, messages.
#include <gtest/gtest.h>

#include <string>

#include "tests/csg/scad/evaluate_text.h"
#include "tests/support/sanitizer.h"

namespace {

using csg::scad::Message;
using csg::scad::Request;
using csg::scad::Severity;
using csg::scad::SourceSet;

TEST(Definitions, OverrideTheFile) {
    Request request;
    request.definitions = {"a=3", "b=[1,2]", "c=\"x\"", "$fn=7;"};
    const test::Run run = test::run("a = 1;\necho(a, b, c, $fn);", {}, request);
    EXPECT_EQ(run.console, "ECHO: 3, [1, 2], \"x\", 7\n");
}

TEST(Request, SpecialVariables) {
    Request request;
    request.time = 0.25;
    request.preview = false;
    request.view = {{1, 2, 3}, {4, 5, 6}, 7, 8};
    const test::Run run = test::run("echo($t, $preview, $vpt, $vpr, $vpd, $vpf);", {}, request);
    EXPECT_EQ(run.console, "ECHO: 0.25, false, [1, 2, 3], [4, 5, 6], 7, 8\n");
}

TEST(View, WhatTheMainFileSets) {
    const auto view = test::run("$vpt = [1, 2, 3]; $vpr = [10, 20];\nmodule m() { $vpd = 5; }\nm();").evaluation.view;
    ASSERT_TRUE(view.translation.has_value());
    EXPECT_EQ(*view.translation, (std::array<double, 3>{1, 2, 3}));
    ASSERT_TRUE(view.rotation.has_value());
    EXPECT_EQ(*view.rotation, (std::array<double, 3>{10, 20, 0}));
    EXPECT_FALSE(view.distance.has_value());
    EXPECT_FALSE(view.fov.has_value());
}

TEST(View, WarnsOfWhatIsNone) {
    const test::Run run = test::run("$vpt = [1, 2, 3, 4];\n$vpr = \"x\";\n$vpd = [1];\n$vpf = 30;");
    EXPECT_EQ(run.console,
              "WARNING: Unable to convert $vpr=\"x\" to a vec3 or vec2 of numbers\n"
              "WARNING: Unable to convert $vpt=[1, 2, 3, 4] to a vec3 or vec2 of numbers\n"
              "WARNING: Unable to convert $vpd=[1] to a number\n");
    EXPECT_EQ(run.evaluation.view.fov, 30);
    EXPECT_FALSE(run.evaluation.view.translation.has_value());
}

TEST(Result, FilesAndCounts) {
    const test::Run run = test::run("include <a.scad>\nuse <b.scad>\necho(a, b());\ncube(\"x\");",
                                    {{"a.scad", "a = 1;"}, {"b.scad", "function b() = assert(true) 2;"}});
    EXPECT_TRUE(run.evaluation.ok);
    EXPECT_EQ(run.evaluation.files, (std::vector<std::string>{test::kMainFile, "a.scad", "b.scad"}));
    EXPECT_EQ(run.evaluation.warnings, 1U);
    EXPECT_EQ(run.evaluation.errors, 0U);
}

TEST(Result, OfDeepCallsWhoseArgumentsWait) {
    const int depth = test_support::kAddressSanitizer ? 6000 : 20000;  // Its stack ends at about 7,700 calls.
    const test::Run run =
        test::run("function deep(n, a = [1, 2]) = n == 0 ? 0 : a[0] + deep(n - 1, [a[1], a[0]]) + len(a);\necho(deep(" +
                  std::to_string(depth) + "));");
    EXPECT_EQ(run.console, "ECHO: " + std::to_string(depth / 2 * 7) + "\n");
}

TEST(Result, NothingIsATreeWithoutRoot) {
    for (const char* program : {"", "a = 1;", "module m() cube();", "*cube();", "echo(1);"}) {
        const test::Run run = test::run(program);
        ASSERT_TRUE(run.evaluation.ok) << program;
        EXPECT_EQ(run.evaluation.tree->root(), csg::kNoNode) << program;
        EXPECT_EQ(run.csg, "");
    }
}

TEST(Result, PlacesOfNodes) {
    const test::Run run = test::run("module m() {\n  cube();\n}\n  translate([1, 0, 0]) m();\ninclude <a.scad>",
                                    {{"a.scad", "\n sphere();"}});
    const csg::Tree& tree = *run.evaluation.tree;
    const auto top = tree.children(tree.root());
    ASSERT_EQ(top.size(), 2U);
    EXPECT_EQ(tree.node(top[0]).where, (csg::SourceLocation{0, 4, 3}));
    const csg::NodeId call = tree.children(top[0])[0];
    EXPECT_EQ(tree.node(call).where, (csg::SourceLocation{0, 4, 24}));
    EXPECT_EQ(tree.node(tree.children(call)[0]).where, (csg::SourceLocation{0, 2, 3}));
    const csg::SourceLocation sphere = tree.node(top[1]).where;
    EXPECT_EQ(tree.files()[sphere.file], "a.scad");
    EXPECT_EQ(sphere.line, 2U);
}

TEST(Result, EqualSubtreesAreShared) {
    const test::Run run = test::run("for (i = [0:999]) rotate([0, 0, 90]) cube(2);");
    EXPECT_LT(run.evaluation.tree->size(), 5U);
    const csg::Tree& tree = *run.evaluation.tree;
    EXPECT_EQ(tree.children(tree.children(tree.root())[0]).size(), 1000U);
}

TEST(Messages, HavePlaces) {
    Request request;
    request.path = test::kMainFile;
    request.text = "a = 1;\ntranslate([a,\n 0, 0]) cube(\"x\");\nassert(a > 2);";
    std::vector<Message> messages;
    (void)csg::scad::evaluate(request, [&](const Message& m, const SourceSet&) { messages.push_back(m); });
    ASSERT_EQ(messages.size(), 3U);
    EXPECT_EQ(messages[0].severity, Severity::Warning);
    EXPECT_EQ(messages[0].where, (csg::scad::SourceRange{0, 3, 9, 3, 18}));
    EXPECT_EQ(messages[1].severity, Severity::Error);
    EXPECT_EQ(messages[1].where.line, 4U);
    EXPECT_EQ(messages[2].severity, Severity::Trace);
}

TEST(Messages, MissingMainFile) {
    Request request;
    request.path = "/nowhere/at/all.scad";
    std::string console;
    const auto evaluation =
        csg::scad::evaluate(request, [&](const Message& m, const SourceSet& s) { console += render_openscad(m, s); });
    EXPECT_FALSE(evaluation.ok);
    EXPECT_EQ(evaluation.errors, 1U);
    EXPECT_NE(console.find("/nowhere/at/all.scad"), std::string::npos);
}

TEST(Messages, NoSinkIsFine) {
    Request request;
    request.path = test::kMainFile;
    request.text = "echo(1); cube(\"a\"); assert(false);";
    EXPECT_FALSE(csg::scad::evaluate(request, {}).ok);
}

TEST(CsgText, IsAProgramThatGivesItself) {
    const std::string program =
        "difference() { cube([1, 2, 3], center = true); translate([0.5, 0, 0]) rotate([10, 20, 30]) sphere(1, $fn = "
        "9); "
        "}\n#color(\"red\", 0.5) cylinder(h = 2, d1 = 1, d2 = 0);\n%polyhedron([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, "
        "0, 1]], "
        "[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]);\nfor (i = [1:2]) if (i > 1) intersection() { cube(i); cube(1); "
        "}";
    const std::string once = test::run(program).csg;
    const test::Run again = test::run(once);
    EXPECT_EQ(again.console, "");
    EXPECT_EQ(again.csg, once);
}

TEST(Random, IsTheSameInEveryRun) {
    const std::string program = "echo(rands(0, 1, 5), rands(0, 1, 5));";
    const std::string first = test::run(program).console;
    EXPECT_EQ(test::run(program).console, first);
}

TEST(Strings, InvalidUtf8IsSplitByFirstBytes) {
    // The first bytes say 1, 2 and 2 bytes; \xC4 at the end has no second one.
    const test::Run run =
        test::run("t = \"\xA4\xC4\xD6\xDC\xDF\xC4\";\necho(len(t), [for (c = t) len(c)], ord(t[1]), ord(\"a\"));");
    EXPECT_EQ(run.console,
              "WARNING: ord() argument '\xC4\xD6' is not a valid utf8 string in file case.scad, line 2\n"
              "ECHO: 4, [1, 1, 1, 1], undef, 97\n");
    EXPECT_EQ(test::run("echo(ord(\"\xED\xA0\x80\"), ord(\"\xE2\x82\xAC\"));").console,
              "WARNING: ord() argument '\xED\xA0\x80' is not a valid utf8 string in file case.scad, line 1\n"
              "ECHO: undef, 8364\n")
        << "a surrogate is no character";
}

TEST(Functions, LastBitsAreOpenScads) {
    // Fractions of 2^-52 that OpenSCAD 2021.01 gives; the differences tell orders of multiplications.
    const test::Run run = test::run(
        "echo(asin(sin(1)) == 1, acos(cos(1)) == 1, atan(tan(1)) == 1, atan2(-0.0, -1) == -180);\n"
        "echo(log(1000) - 3 != 0, tan(90), tan(-90), tan(270), tan(45) == 1, sin(1e20));\n"
        "echo((atan(0.3) - 16.69924423399362) * 1e15, (tan(10.5) - 0.18533904493153439) * 1e17);");
    EXPECT_EQ(run.console, "ECHO: true, true, true, true\nECHO: true, inf, -inf, -inf, true, nan\nECHO: 0, 0\n");
}

}  // namespace
