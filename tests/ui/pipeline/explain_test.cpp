// What an operation did, and the model without it: by points of parts made of boxes.
#include "csg/tree/explain.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/csg/scad/evaluate_text.h"
#include "ui/pipeline/model.h"

namespace ui {
namespace {

constexpr const char* kModel =
    "module slot() translate([2, -1, 3]) cube([2, 20, 20]);\n"
    "translate([100, 0, 0]) color(\"blue\") difference() {\n"
    "  cube(10);\n"
    "  slot();\n"
    "}\n"
    "intersection() {\n"
    "  cube(10);\n"
    "  translate([5, 0, 0]) cube([10, 10, 4]);\n"
    "}\n";

std::shared_ptr<const csg::Tree> tree_of(const std::string& text) {
    const test::Run run = test::run(text);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    return run.evaluation.tree;
}

/// Names of the parts that hold the point, with blanks between.
std::string parts_at(const csg::Tree& tree, const glm::dvec3& point) {
    ModelBuilder builder;
    builder.divide({csg::PartRule::Kind::Color, 1, {}});
    const auto model = builder.build(std::make_shared<const csg::Tree>(tree));
    std::string names;
    std::vector<char> values;
    const auto inside = [&](csg::LeafId leaf) {
        const csg::Box& box = model->geometry.leaves[leaf].box;
        return csg::enclose(box, point) == box;
    };
    for (const csg::Part& part : model->scene.parts) {
        names += csg::evaluate(model->scene, part, inside, values) ? (names.empty() ? "" : " ") + part.name : "";
    }
    return names;
}

constexpr const char *kRemoved = "#db33298c", *kCutter = "#8080801a", *kKept = "#40ad4d", *kLost = "#db3d3326";

TEST(Explain, FindsDifferencesAndIntersections) {
    const auto tree = tree_of(kModel);
    const auto calls = csg::explainable(*tree);
    ASSERT_EQ(calls.size(), 2u);
    EXPECT_EQ(calls[0]->name, "difference");
    EXPECT_EQ(calls[0]->where.line, 2u);
    EXPECT_EQ(calls[1]->name, "intersection");
}

TEST(Explain, WhatADifferenceRemovedIsAGhost) {
    const auto tree = tree_of(kModel);
    const csg::Tree shown = csg::explained(*tree, csg::explainable(*tree)[0]->where);
    EXPECT_EQ(parts_at(shown, {103, 5, 5}), kRemoved);
    EXPECT_EQ(parts_at(shown, {103, 5, 15}), kCutter);
    EXPECT_EQ(parts_at(shown, {101, 5, 5}), "#0000ff");
    EXPECT_EQ(parts_at(shown, {3, 5, 5}), "");
    EXPECT_EQ(parts_at(shown, {7, 5, 2}), "uncolored");
}

TEST(Explain, WhatAnIntersectionKeptIsGreen) {
    const auto tree = tree_of(kModel);
    const csg::Tree shown = csg::explained(*tree, csg::explainable(*tree)[1]->where);
    EXPECT_EQ(parts_at(shown, {7, 5, 2}), kKept);
    EXPECT_EQ(parts_at(shown, {2, 5, 2}), kLost);
    EXPECT_EQ(parts_at(shown, {12, 5, 2}), kLost);
    EXPECT_EQ(parts_at(shown, {101, 5, 5}), "uncolored");
    EXPECT_EQ(parts_at(shown, {103, 5, 5}), "");
}

TEST(Explain, OutlinesAreExplainedAsTheyAreExtruded) {
    const auto tree = tree_of("linear_extrude(5) difference() { square(10); translate([2, 2]) square(3); }");
    const csg::Tree shown = csg::explained(*tree, csg::explainable(*tree)[0]->where);
    // The outline is one leaf, whose box is all that is asked here.
    EXPECT_EQ(parts_at(shown, {3, 3, 2}), std::string("uncolored ") + kRemoved);
    EXPECT_EQ(parts_at(shown, {7, 7, 2}), "uncolored");
}

TEST(Explain, TheModelWithoutACall) {
    const auto tree = tree_of(kModel);
    const auto place = [&](std::uint32_t line, std::uint32_t column) { return csg::SourceLocation{0, line, column}; };
    EXPECT_EQ(parts_at(csg::without(*tree, place(2, 38)), {103, 5, 5}), "#0000ff");
    EXPECT_EQ(parts_at(csg::without(*tree, place(4, 3)), {103, 5, 5}), "#0000ff");
    EXPECT_EQ(parts_at(csg::without(*tree, place(6, 1)), {12, 5, 2}), "uncolored");
    EXPECT_EQ(parts_at(csg::without(*tree, place(2, 24)), {101, 5, 5}), "uncolored");
    EXPECT_EQ(parts_at(csg::without(*tree, place(2, 1)), {9, 5, 9}), "#0000ff");
    EXPECT_EQ(parts_at(csg::without(*tree, place(7, 3)), {7, 5, 2}), "");
}

}  // namespace
}  // namespace ui
