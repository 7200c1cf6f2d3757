// Which nodes the scene takes as one leaf.
#include <gtest/gtest.h>

#include <algorithm>

#include "csg/solid/placed.h"
#include "tests/csg/scad/evaluate_text.h"

namespace {

csg::Scene scene_of(const std::string& model) {
    const test::Run run = test::run(model);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    return csg::make_scene(*run.evaluation.tree);
}

TEST(SceneOfNodes, LeavesAreWhatMakesOneMesh) {
    const struct {
        const char* model;
        std::size_t leaves;
    } table[]{{"linear_extrude(3) { square(1); circle(2); }", 1},
              {"hull() { cube(1); sphere(2); translate([3,0,0]) cube(1); }", 1},
              {"difference() { square(3); circle(1); circle(2); }", 1},
              {"difference() { cube(3); linear_extrude(1) difference() { square(3); circle(1); } }", 2},
              {"union() { square(3); circle(1); }", 2},
              {"render() { cube(1); sphere(1); }", 2},
              {"difference() { color(\"red\") square(3); circle(1); }", 2},
              {"linear_extrude(1) { square(1); %circle(9); }", 1}};
    for (const auto& row : table) {
        EXPECT_EQ(scene_of(row.model).leaves.size(), row.leaves) << row.model;
    }
}

TEST(SceneOfNodes, HighlightsInAFlatDifferenceAreParts) {
    const csg::Scene scene = scene_of("difference() { square(3); #circle(1); }");
    EXPECT_EQ(std::count_if(scene.parts.begin(), scene.parts.end(),
                            [](const csg::Part& part) { return part.kind == csg::PartKind::Highlight; }),
              1);
}

TEST(SceneOfNodes, ColorsOfAFlatDifferenceStay) {
    const csg::Scene scene = scene_of("difference() { color(\"red\") square(3); circle(1); }");
    ASSERT_EQ(scene.leaves.size(), 2u);
    EXPECT_FLOAT_EQ(scene.leaves[0].color.r, 1);
}

/// "kind:leaves" of each part.
std::string parts_of(const std::string& model) {
    const csg::Scene scene = scene_of(model);
    std::string text;
    for (const csg::Part& part : scene.parts) {
        text += std::string(csg::name(part.kind)) + ":" + std::to_string(part.leaf_count) + " ";
    }
    return text;
}

/// As OpenSCAD's preview: in a union it is highlighted instead, elsewhere as well.
TEST(SceneOfNodes, WhatAHighlightTakesAway) {
    const std::pair<const char*, const char*> table[]{
        {"#cube(1); sphere(2);", "solid:1 highlight:1 "},
        {"union() { #cube(1); group() { } } sphere(2);", "solid:1 highlight:1 "},
        {"#cube(1);", "solid:1 highlight:1 "},
        {"#cube(1); #sphere(2);", "solid:2 highlight:2 "},
        {"difference() { cube(1); #sphere(2); }", "solid:2 highlight:1 "},
        {"difference() { #cube(1); sphere(2); }", "solid:2 highlight:2 "},
        {"difference() { #cube(1); sphere(2); } cube(3);", "solid:1 highlight:2 "},
        {"intersection() { #cube(1); sphere(2); } cube(3);", "solid:3 highlight:1 "},
        {"intersection() { #cube(1); #sphere(2); } cube(3);", "solid:1 highlight:2 "},
        {"difference() { union() { #cube(1); cube(4); } sphere(2); }", "solid:2 highlight:1 "},
        {"#union() { #cube(1); sphere(2); } cube(4);", "solid:1 highlight:2 "},
        {"color(\"red\", 0.5) #cube(1); sphere(2);", "solid:1 highlight:1 "},
        {"#%cube(1); sphere(2);", "solid:1 background:1 "},
        {"hull() { #cube(1); sphere(2); %cylinder(); }", "solid:1 highlight:1 background:1 "},
        {"minkowski() { cube(1); translate([1, 0, 0]) #sphere(2); }", "solid:1 highlight:1 "},
        {"linear_extrude(1) { #square(1); circle(2); }", "solid:1 "},
    };
    for (const auto& [model, parts] : table) {
        EXPECT_EQ(parts_of(model), parts) << model;
    }
}

TEST(SceneOfNodes, ColorsInPart) {
    const std::string translucent = "translucent:1 ";
    EXPECT_EQ(parts_of("color(alpha = 0.3) cube();"), translucent);
    EXPECT_EQ(parts_of("color(undef, 0.3) cube();"), translucent);
    EXPECT_EQ(parts_of("color([1, 0, 0], alpha = -1) cube();"), "solid:1 ");
    const auto color = [](const std::string& model) { return scene_of(model).leaves[0].color; };
    const csg::Rgba red{1, 0, 0, 1};
    EXPECT_EQ(color("color(\"red\") color([-1, -1, -1]) cube();"), red);
    EXPECT_EQ(color("color([-1, -1, -1]) color(\"red\") cube();"), red);
    EXPECT_EQ(color("color(alpha = 0.3) color(\"red\") cube();"), red) << "the inner one gives all";
    EXPECT_EQ(color("color([-1, 0.5, 2]) cube();"), (csg::Rgba{-1, 0.5, 2, 1}));
}

TEST(SceneOfNodes, AResultIsTheSolidAlone) {
    const struct {
        const char* model;
        std::size_t parts, leaves;
    } table[]{{"cube(1); %cube(9);", 1, 1},
              {"difference() { cube(3); #cube(1); }", 1, 2},
              {"%sphere(1);", 0, 0},
              {"cube(1); square(3);", 1, 1},
              {"#cube(1); sphere(3);", 1, 2},
              {"intersection() { cube(1); square(3); }", 1, 1},
              {"square(3); translate([1, 1]) circle(1); color(\"red\") text(\"A\");", 1, 1},
              {"translate([5, 0]) square(3);", 1, 1}};
    for (const auto& row : table) {
        const test::Run run = test::run(row.model);
        const csg::Scene scene = csg::make_scene(*run.evaluation.tree, csg::Showing::Result);
        EXPECT_EQ(scene.parts.size(), row.parts) << row.model;
        EXPECT_EQ(scene.leaves.size(), row.leaves) << row.model;
    }
}

TEST(SceneOfNodes, AFlatResultStandsWhereItIs) {
    const test::Run run = test::run("translate([5, 0]) square(3);");
    csg::solid::SolidCache cache;
    const auto geometry =
        csg::solid::place(*run.evaluation.tree, csg::make_scene(*run.evaluation.tree, csg::Showing::Result), cache);
    ASSERT_EQ(geometry.leaves.size(), 1u);
    EXPECT_EQ(geometry.box.lo.x, 5);
    EXPECT_EQ(geometry.box.hi.x, 8);
}

TEST(SceneOfNodes, WhatCannotBeMadeIsToldWithItsPlace) {
    const test::Run run = test::run("cube(1);\n\nlinear_extrude(2)\n  cube(1);\nhull() { cube(1); sphere(1); }");
    csg::solid::SolidCache cache;  // Without exact operations.
    const auto geometry = csg::solid::place(*run.evaluation.tree, csg::make_scene(*run.evaluation.tree), cache);
    ASSERT_EQ(geometry.warnings.size(), 1u);
    ASSERT_EQ(geometry.failures.size(), 1u);
    EXPECT_EQ(geometry.warnings[0].substr(0, 12), "case.scad:4:") << "the child that does not fit";
    EXPECT_EQ(geometry.failures[0].substr(0, 12), "case.scad:5:");
}

TEST(SolidCache, MakesANodeOnce) {
    const test::Run run = test::run("for (i = [0:3]) translate([9 * i, 0, 0]) linear_extrude(2) square(3);");
    const csg::Scene scene = csg::make_scene(*run.evaluation.tree);
    csg::solid::SolidCache cache;
    const auto first = csg::solid::place(*run.evaluation.tree, scene, cache);
    cache.trim();
    const auto second = csg::solid::place(*run.evaluation.tree, scene, cache);
    ASSERT_EQ(first.leaves.size(), 4u);
    for (const auto& leaf : second.leaves) {
        EXPECT_EQ(leaf.solid, first.leaves[0].solid);
    }
    cache.trim();
    cache.trim();
    EXPECT_NE(csg::solid::place(*run.evaluation.tree, scene, cache).leaves[0].solid, first.leaves[0].solid);
}

}  // namespace
