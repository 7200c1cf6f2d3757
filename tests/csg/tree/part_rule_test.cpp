// What the rules make parts of.
#include <gtest/gtest.h>

#include <random>
#include <unordered_map>

#include "csg/tree/hash.h"
#include "csg/tree/scene.h"
#include "tests/csg/scad/evaluate_text.h"
#include "tests/random/random_tree.h"

namespace {

using csg::PartRule;

const PartRule kTop{PartRule::Kind::Depth, 1, {}}, kColor{PartRule::Kind::Color, 1, {}};

PartRule depth(unsigned n) {
    return {PartRule::Kind::Depth, n, {}};
}

PartRule modules(std::vector<std::string> names) {
    return {PartRule::Kind::Module, 1, std::move(names)};
}

/// "name:leaves" of each part, with its kind where that is not Solid.
std::vector<std::string> parts_of(const std::string& text, const PartRule& rule,
                                  csg::Showing showing = csg::Showing::Preview) {
    const test::Run run = test::run(text);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    const csg::Scene scene = csg::make_scene(*run.evaluation.tree, showing, rule);
    static constexpr const char* kKinds[]{"", " translucent", " background", " highlight"};
    std::vector<std::string> parts;
    for (const csg::Part& part : scene.parts) {
        parts.push_back(part.name + ":" + std::to_string(part.leaf_count) + kKinds[static_cast<int>(part.kind)]);
    }
    return parts;
}

using Parts = std::vector<std::string>;

TEST(PartRules, TheModelIsOnePart) {
    EXPECT_EQ(parts_of("cube(1); sphere(2); #cylinder(); %cube(4);", {}),
              (Parts{"model:2", "highlight:1 highlight", "background:1 background"}));
    EXPECT_EQ(parts_of("cube(1); color(\"red\", 0.5) sphere(2);", {}), (Parts{"model:1", "#ff000080:1 translucent"}));
    EXPECT_EQ(parts_of("", {}), Parts{});
}

TEST(PartRules, WhatIsTranslucentIsApartWhereverItIsAdded) {
    EXPECT_EQ(parts_of("difference() { union() { color(\"red\", 0.5) cube(3); cube(4); } sphere(1); }", {}),
              (Parts{"model:2", "#ff000080:2 translucent"}));
    EXPECT_EQ(parts_of("difference() { color(\"red\", 0.5) cube(3); sphere(1); }", {}),
              (Parts{"#ff000080:2 translucent"}));
    EXPECT_EQ(
        parts_of("intersection() { translate([1, 0, 0]) { color(\"red\", 0.5) cube(3); cube(1); } cube(2); }", {}),
        (Parts{"model:2", "#ff000080:2 translucent"}));
    EXPECT_EQ(parts_of("translate([1, 0, 0]) { cube(1); color(\"red\", 0.5) sphere(2); sphere(); } cube(3);", kTop),
              (Parts{"part 1:2", "#ff000080:1 translucent", "part 3:1"}))
        << "the rest of a part stays one";
}

TEST(PartRules, CuttersAndColorsFurtherOutAreNotTranslucent) {
    EXPECT_EQ(parts_of("difference() { cube(3); color(\"red\", 0.5) sphere(1); }", {}), (Parts{"model:2"}));
    EXPECT_EQ(parts_of("color(\"blue\") { color(\"red\", 0.5) cube(1); cube(2); }", {}), (Parts{"model:2"}));
    EXPECT_EQ(parts_of("color(\"nonsense\") cube(1);", {}), (Parts{"model:1"}));
}

TEST(PartRules, OpacityAloneMakesAPartTranslucent) {
    EXPECT_EQ(parts_of("color(alpha = 0.5) cube(1); cube(2);", {}), (Parts{"model:1", "translucent:1 translucent"}));
    EXPECT_EQ(parts_of("color(alpha = 0.5) { cube(1); color(\"red\") cube(2); color(\"lime\", 0.2) cube(3); }", {}),
              (Parts{"model:1", "translucent:1 translucent", "#00ff0033:1 translucent"}));
}

TEST(PartRules, TopIsTheChildrenOfTheTopLevelUnion) {
    const std::string model =
        "module cover() { cube(1); sphere(1); }\n"
        "cover(); translate([3, 0, 0]) cover(); color(\"#ff8000\") cylinder();\n"
        "difference() { cube(3); sphere(1); }\n";
    EXPECT_EQ(parts_of(model, kTop), (Parts{"cover:2", "cover 2:2", "#ff8000:1", "part 4:2"}));
    EXPECT_EQ(parts_of("module all() {" + model + "} rotate(9) all();", kTop), parts_of(model, kTop))
        << "unions of one child are passed";
    EXPECT_EQ(parts_of("difference() { union() { cube(3); sphere(2); } cylinder(); }", kTop), (Parts{"part 1:3"}));
    EXPECT_EQ(parts_of("cube(1); echo(2); if (false) cube(1); %sphere(1);", kTop),
              (Parts{"part 1:1", "background:1 background"}));
}

TEST(PartRules, DepthDividesFurther) {
    const std::string model = "union() { cube(1); cube(2); } difference() { union() { cube(3); cube(4); } cube(5); }";
    EXPECT_EQ(parts_of(model, depth(1)), (Parts{"part 1:2", "part 2:3"}));
    EXPECT_EQ(parts_of(model, depth(2)), (Parts{"part 1:1", "part 2:1", "part 3:3"}));
    EXPECT_EQ(parts_of(model, depth(3)), (Parts{"part 1:1", "part 2:1", "part 3:2", "part 4:2"}))
        << "each has a copy of what is subtracted";
    EXPECT_EQ(parts_of(model, depth(1000)), parts_of(model, depth(3)));
}

TEST(PartRules, ColorPutsTogetherWhatHasOne) {
    EXPECT_EQ(parts_of("color(\"red\") cube(1); cube(2); union() { color(\"lime\") { cube(3); cube(4); } "
                       "translate([1, 0, 0]) color(\"red\") { cube(5); color(\"blue\") cube(6); } }",
                       kColor),
              (Parts{"#ff0000:3", "uncolored:1", "#00ff00:2"}));
    EXPECT_EQ(
        parts_of("difference() { color(\"red\") cube(1); color(\"blue\") cube(2); } color(\"red\") cube(3);", kColor),
        (Parts{"#ff0000:3"}))
        << "a difference has the color of what is cut";
    EXPECT_EQ(parts_of("intersection() { union() { color(\"red\") cube(1); cube(2); } cube(3); }", kColor),
              (Parts{"#ff0000:2", "uncolored:2"}));
    EXPECT_EQ(parts_of("color(\"red\", 0.5) cube(1); union() { color(\"red\", 0.5) cube(2); color(\"red\") cube(3); }",
                       kColor),
              (Parts{"#ff000080:2 translucent", "#ff0000:1"}));
}

TEST(PartRules, ModulesAreFoundBelowDifferences) {
    const std::string model =
        "module pin() cylinder();\n"
        "module base() { cube(9); pin(); }\n"
        "difference() { union() { base(); translate([3, 0, 0]) pin(); cube(7); } sphere(1); }\n"
        "sphere(4);\n";
    EXPECT_EQ(parts_of(model, modules({"pin"})), (Parts{"rest:4", "pin:2", "pin 2:2"}));
    EXPECT_EQ(parts_of(model, modules({"base", "pin"})), (Parts{"base:3", "pin:2", "rest:3"})) << "the outermost";
    EXPECT_EQ(parts_of(model, modules({"nothing"})), (Parts{"rest:6"}));
    EXPECT_EQ(parts_of("module pin() cube(1); difference() { cube(2); pin(); }", modules({"pin"})), (Parts{"rest:2"}))
        << "what is subtracted is no part";
}

TEST(PartRules, WhatStandsBesideTheSolidIsThereOnce) {
    // The cutter is copied for either part; its highlight is not.
    EXPECT_EQ(parts_of("difference() { union() { cube(3); cube(4); %cube(6); } #cube(5); %cube(7); }", depth(2)),
              (Parts{"part 1:2", "part 2:2", "background:1 background", "highlight:1 highlight",
                     "background 2:1 background"}));
    EXPECT_EQ(parts_of("union() { cube(3); #cube(4); } cube(5); %cube(7);", kTop, csg::Showing::Result),
              (Parts{"part 1:2", "part 2:1"}));
}

TEST(PartRules, ResultsInThePlaneAreOne) {
    EXPECT_EQ(parts_of("square(1); circle(3);", kTop, csg::Showing::Result).size(), 1u);
    EXPECT_EQ(parts_of("square(1); circle(3);", kTop).size(), 2u);
}

TEST(PartRules, PartsHaveTheColorOfTheirMaterial) {
    const test::Run run = test::run(
        "difference() { color(\"red\") { cube(1); cube(2); } color(\"blue\") sphere(1); }\n"
        "union() { color(\"red\") cube(1); color(\"lime\") cube(1); }");
    const csg::Scene scene = csg::make_scene(*run.evaluation.tree, csg::Showing::Preview, kTop);
    ASSERT_EQ(scene.parts.size(), 2u);
    EXPECT_EQ(csg::color_name(scene.parts[0].color), "#ff0000");
    EXPECT_FALSE(scene.parts[1].color.given());
}

TEST(PartRules, DifferencesWithinDifferencesAreDividedToABound) {
    // Without one, the copies would be as many as the square of the depth.
    std::string text = "cube(1);";
    for (int i = 0; i < 200; ++i) {
        text = "difference() { union() { " + text + " cube(2); } cube(3); }";
    }
    const test::Run run = test::run(text);
    const csg::Scene scene = csg::make_scene(*run.evaluation.tree, csg::Showing::Preview, depth(1000));
    EXPECT_EQ(scene.parts.size(), PartRule::kMostShared + 1);
    EXPECT_LT(scene.leaves.size(), 64u * 65u + 500u);
}

/// What the whole scene says of a point, where each leaf, known by the way down to it, holds it or not.
bool holds(const csg::Scene& scene, std::uint64_t point) {
    std::vector<std::uint64_t> ways(scene.occurrences.size());
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const csg::Occurrence& o = scene.occurrences[i];
        ways[i] = o.parent == csg::kNoOccurrence ? point : csg::mix(ways[o.parent], std::uint64_t{o.child});
    }
    std::vector<char> scratch;
    bool any = false;
    for (const csg::Part& part : scene.parts) {
        if (part.kind == csg::PartKind::Solid || part.kind == csg::PartKind::Translucent) {
            any |= csg::evaluate(
                scene, part, [&](csg::LeafId leaf) { return (ways[scene.leaves[leaf].occurrence] >> 20 & 1) != 0; },
                scratch);
        }
    }
    return any;
}

TEST(PartRules, TheUnionOfThePartsIsTheWhole) {
    std::size_t divided = 0, copied = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        std::mt19937_64 random(seed);
        const csg::Tree tree = random_tree::make_tree(random_tree::make_model(random, {20, 6, true, false}));
        const csg::Scene whole = csg::make_scene(tree);
        for (const PartRule& rule : {depth(1), depth(2), depth(4), depth(9), kColor}) {
            const csg::Scene parts = csg::make_scene(tree, csg::Showing::Preview, rule);
            divided += parts.parts.size() > whole.parts.size() ? 1 : 0;
            copied += parts.leaves.size() > whole.leaves.size() ? 1 : 0;
            for (std::uint64_t point = 0; point < 100; ++point) {
                ASSERT_EQ(holds(parts, csg::mix(seed, point)), holds(whole, csg::mix(seed, point)))
                    << "seed " << seed << ", depth " << rule.depth << "\n"
                    << random_tree::scad_text(random_tree::make_model(random, {20, 6, true, false}));
            }
            // The ranges that everything relies on.
            csg::LeafId next = 0;
            for (csg::PartId id = 0; id < parts.parts.size(); ++id) {
                EXPECT_EQ(parts.parts[id].first_leaf, next);
                next += parts.parts[id].leaf_count;
                for (csg::LeafId leaf = parts.parts[id].first_leaf; leaf < next; ++leaf) {
                    EXPECT_EQ(parts.leaves[leaf].part, id);
                }
            }
            EXPECT_EQ(next, parts.leaves.size());
        }
    }
    EXPECT_GT(divided, 500u);
    EXPECT_GT(copied, 200u);
}

}  // namespace
