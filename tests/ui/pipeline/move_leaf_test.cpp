// Solids moved by hand: the text changes in the bytes that are responsible, and the solid lies where it was put.
#include "ui/pipeline/editing/move_leaf.h"
#include "ui/pipeline/editing/scale_leaf.h"
#include "ui/pipeline/editing/sparse_step.h"

#include <gtest/gtest.h>

#include "tests/csg/scad/evaluate_text.h"

namespace ui {
namespace {

using Kind = MoveWay::Kind;

struct Moved {
    std::vector<MoveWay> ways;
    std::string text;  ///< After the first of them.
};

/// The leaf of that number, by document order, moved.
Moved move(const std::string& text, csg::LeafId leaf, const glm::dvec3& by,
           const std::map<std::string, std::string>& files = {}) {
    csg::scad::ProgramCache programs;
    const auto tree_of = [&](const std::string& changed) {
        return test::run_kept(programs, changed, files).evaluation.tree;
    };
    const test::Run run = test::run_kept(programs, text, files);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    const csg::Scene scene = csg::make_scene(*run.evaluation.tree);
    // The cache may put another text into this program later: another stays as it is.
    csg::scad::ProgramCache kept;
    const test::Run same = test::run_kept(kept, text, files);
    Moved moved;
    moved.ways = ways_to_move(*run.evaluation.tree, scene, *same.evaluation.program, text, leaf, by, tree_of);
    for (const MoveWay& way : moved.ways) {
        const test::Run after = test::run(edited(text, way.edits), files);
        const csg::Scene there = csg::make_scene(*after.evaluation.tree);
        EXPECT_LE(
            glm::distance(glm::dvec3(there.leaves[leaf].to_world[3]), glm::dvec3(scene.leaves[leaf].to_world[3]) + by),
            1e-6);
    }
    moved.text = moved.ways.empty() ? "" : edited(text, moved.ways.front().edits);
    return moved;
}

/// What a search of ways makes of the text, of its only leaf; empty where there is none.
template <typename Search>
std::string text_by(const std::string& text, const Search& search) {
    csg::scad::ProgramCache programs, kept;
    const TreeOfText tree_of = [&](const std::string& changed) {
        return test::run_kept(programs, changed, {}).evaluation.tree;
    };
    const test::Run run = test::run_kept(kept, text, {});
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    const csg::Scene scene = csg::make_scene(*run.evaluation.tree);
    const std::vector<MoveWay> ways = search(*run.evaluation.tree, scene, *run.evaluation.program, tree_of);
    return ways.empty() ? "" : edited(text, ways.front().edits);
}

std::string turned_text(const std::string& text, const glm::dvec3& turn) {
    return text_by(text, [&](const auto& tree, const auto& scene, const auto& program, const auto& tree_of) {
        return ways_to_turn(tree, scene, program, text, 0, turn, tree_of);
    });
}

std::string stretched_text(const std::string& text, int axis, bool upper, double by) {
    return text_by(text, [&](const auto& tree, const auto& scene, const auto& program, const auto& tree_of) {
        return ways_to_stretch(tree, scene, program, text, 0, axis, upper, by, tree_of);
    });
}

std::string scaled_text(const std::string& text, const glm::dvec3& factors) {
    return text_by(text, [&](const auto& tree, const auto& scene, const auto& program, const auto& tree_of) {
        return ways_to_scale(tree, scene, program, text, 0, factors, tree_of);
    });
}

std::string moved_text(const std::string& text, const glm::dvec3& by, csg::LeafId leaf = 0) {
    return move(text, leaf, by).text;
}

TEST(MoveLeaf, ChangesTheNumbersOfItsCall) {
    EXPECT_EQ(moved_text("translate([1, 2, 3]) cube(4);  // here", {0.5, 0, -3}),
              "translate([1.5, 2, 0]) cube(4);  // here");
    EXPECT_EQ(moved_text("cube(1); translate( [ -1,/*y*/2 ,0] ) { sphere(1); }", {0, 0.25, 0}, 1),
              "cube(1); translate( [ -1,/*y*/2.25 ,0] ) { sphere(1); }");
    EXPECT_EQ(moved_text("rotate(90) translate([5, 0, 0]) cube(1);", {0, 1, 0}),
              "rotate(90) translate([6, 0, 0]) cube(1);");
    EXPECT_EQ(moved_text("scale(2) translate([5, 0, 0]) cube(1);", {1, 0, 0}),
              "scale(2) translate([5.5, 0, 0]) cube(1);");
}

TEST(MoveLeaf, SolvesWhatIsComputed) {
    EXPECT_EQ(moved_text("translate([2 * 3 + 1, 0, 0]) cube(1);", {0.5, 0, 0}).find("wrap"), std::string::npos);
    const std::string text = "wall = 2;\ngap = wall / 4;\ntranslate([wall + gap, 0, -wall]) cube(1);\n";
    const Moved along = move(text, 0, {1.25, 0, -1});
    ASSERT_FALSE(along.ways.empty());
    EXPECT_EQ(along.ways.front().kind, Kind::Variable);
    EXPECT_EQ(along.ways.front().name, "wall");
    EXPECT_EQ(along.text, "wall = 3;\ngap = wall / 4;\ntranslate([wall + gap, 0, -wall]) cube(1);\n");
    EXPECT_EQ(moved_text("a = [1, 2, 3];\ntranslate(a) cube(1);", {0, 0, 1}), "a = [1, 2, 4];\ntranslate(a) cube(1);");
    EXPECT_EQ(moved_text("module post(x) translate([x, 0, 0]) cube(1);\npost(3);", {2, 0, 0}),
              "module post(x) translate([x, 0, 0]) cube(1);\npost(5);");
    // Not a line: an angle's sine.
    const Moved bent = move("translate([10 * sin(30), 0, 0]) cube(1);", 0, {1, 0, 0});
    ASSERT_FALSE(bent.ways.empty());
    EXPECT_EQ(bent.ways.front().kind, Kind::Call);
}

TEST(MoveLeaf, ChangesAsFewNumbersAsDo) {
    // Of the three, the one that gets the shortest decimals.
    EXPECT_EQ(moved_text("translate([2 * 3 + 1, 0, 0]) cube(1);", {0.5, 0, 0}),
              "translate([2 * 3 + 1.5, 0, 0]) cube(1);");
    EXPECT_EQ(moved_text("module m(a) translate(a) cube(1);\nm([1 + 1, 2 * 4, 0]);", {0, 1, 0}),
              "module m(a) translate(a) cube(1);\nm([1 + 1, 2 * 4.5, 0]);");
    // An axis by a loop's list, another by the call within it.
    const Moved both = move("for (x = [5, 35]) translate([x, 5, 0]) cube(1);", 1, {3, 2, 0});
    EXPECT_EQ(both.text, "for (x = [5, 38]) translate([x, 7, 0]) cube(1);");
    ASSERT_FALSE(both.ways.empty());
    EXPECT_EQ(both.ways.front().name, "for() and translate");
    EXPECT_EQ(both.ways.front().kind, Kind::Call);
}

TEST(TurnLeaf, ChangesAnglesOrPutsARotationThere) {
    EXPECT_EQ(turned_text("rotate([0, 0, 10]) cube(1);", {0, 0, 25}), "rotate([0, 0, 35]) cube(1);");
    EXPECT_EQ(turned_text("rotate(10) cube(1);", {0, 0, -15}), "rotate(-5) cube(1);");
    EXPECT_EQ(turned_text("cube(1);", {90, 0, 0}), "rotate([90, 0, 0]) cube(1);");
    EXPECT_EQ(turned_text("translate([1, 2, 3]) cube(1);", {0, 90, 0}),
              "translate([1, 2, 3]) rotate([0, 90, 0]) cube(1);");
    // In the world, about its own origin: what is above is undone.
    EXPECT_EQ(turned_text("rotate([90, 0, 0]) cube(1);", {0, 0, 30}), "rotate([90, 0, 30]) cube(1);");
    EXPECT_EQ(turned_text("module m() translate([4, 0, 0]) sphere(1);\nm();", {0, 0, 90}),
              "module m() translate([4, 0, 0]) rotate([0, 0, 90]) sphere(1);\nm();");
    // Below a scale that is not even no rotation does it.
    EXPECT_EQ(turned_text("scale([1, 2, 1]) cube(1);", {0, 0, 30}), "rotate([0, 0, 30]) scale([1, 2, 1]) cube(1);");
}

TEST(StretchLeaf, ChangesTheNumberOfThatSide) {
    EXPECT_EQ(stretched_text("cube([1, 2, 3]);", 1, true, 0.5), "cube([1, 2.5, 3]);");
    EXPECT_EQ(stretched_text("cube(3);", 0, true, 1), "cube(4);");
    EXPECT_EQ(stretched_text("scale(2) cube([1, 2, 3], center = true);", 0, true, 1),
              "scale(2) cube([2, 2, 3], center = true);");
    EXPECT_EQ(stretched_text("h = 4;\nrotate([90, 0, 0]) cylinder(h = 2 * h, r = 1);", 2, true, 1),
              "h = 4;\nrotate([90, 0, 0]) cylinder(h = 2.25 * h, r = 1);");
    EXPECT_EQ(stretched_text("h = 4;\nrotate([90, 0, 0]) cylinder(h = h, r = 1);", 2, true, 1),
              "h = 5;\nrotate([90, 0, 0]) cylinder(h = h, r = 1);");
    EXPECT_EQ(stretched_text("sphere(r = 2, $fn = 64);", 0, false, -0.5), "sphere(r = 1.5, $fn = 64);");
    EXPECT_EQ(stretched_text("linear_extrude(5) square(2);", 2, true, 2), "linear_extrude(7) square(2);");
    // A translate() moves that side, and is no way to stretch it; nor is there one for the side at the origin.
    EXPECT_EQ(stretched_text("translate([1, 0, 0]) cube([1, 2, 3]);", 0, false, 1), "");
    EXPECT_EQ(stretched_text("hull() { cube(1); sphere(2); }", 0, true, 1), "");
}

TEST(ScaleLeaf, ChangesTheNumbersOfTheShape) {
    EXPECT_EQ(scaled_text("translate([5, 0, 0]) cube([1, 2, 3]);", {2, 1, 0.5}),
              "translate([5, 0, 0]) cube([2, 2, 1.5]);");
    EXPECT_EQ(scaled_text("rotate(30) sphere(r = 2, $fn = 8);", {1.5, 1.5, 1.5}), "rotate(30) sphere(r = 3, $fn = 8);");
    EXPECT_EQ(scaled_text("cylinder(h = 4, r = 2, $fn = 8);", {2, 2, 1}), "cylinder(h = 4, r = 4, $fn = 8);");
    EXPECT_EQ(scaled_text("cylinder(h = 4, r1 = 2, r2 = 1, $fn = 8);", {2, 2, 2}),
              "cylinder(h = 8, r1 = 4, r2 = 2, $fn = 8);");
    EXPECT_EQ(scaled_text("a = 3;\ncube(2 * a);", {2, 2, 2}), "a = 3;\ncube(4 * a);");
}

TEST(ScaleLeaf, ChangesAScaleOrPutsOneThere) {
    EXPECT_EQ(scaled_text("scale([1, 2, 1]) translate([0, 0, 0]) linear_extrude(3) circle(2);", {2, 1.5, 1}),
              "scale([2, 3, 1]) translate([0, 0, 0]) linear_extrude(3) circle(2);");
    // A cylinder that is to be an ellipse.
    EXPECT_EQ(scaled_text("translate([1, 1, 0]) cylinder(h = 4, r = 2, $fn = 8);", {2, 1, 1}),
              "translate([1, 1, 0]) scale([2, 1, 1]) cylinder(h = 4, r = 2, $fn = 8);");
    EXPECT_EQ(scaled_text("polyhedron([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2], [0, 3, 1], [1, 3, 2], "
                          "[2, 3, 0]]);",
                          {1, 3, 1}),
              "scale([1, 3, 1]) polyhedron([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2], [0, 3, 1], [1, "
              "3, 2], [2, 3, 0]]);");
    EXPECT_EQ(scaled_text("cube(1);", {0, 1, 1}), "") << "nothing would be left";
}

TEST(SparseStep, ReachesWithTheFewest) {
    const std::vector<glm::dvec3> columns{{1, 0, 0}, {0, 2, 0}, {1, 2, 0}, {0, 0, 0}, {3, 0, 0}};
    const std::vector<double> values{0.1, 0, 1, 0, 0};
    const auto one = sparse_step(columns, {1.5, 3, 0}, values, 1e-9);
    ASSERT_TRUE(one);
    ASSERT_EQ(one->size(), 1u);
    EXPECT_EQ(one->front().first, 2u);
    EXPECT_NEAR(one->front().second, 1.5, 1e-12);
    const auto two = sparse_step(columns, {1, 4, 0}, values, 1e-9);
    ASSERT_TRUE(two);
    ASSERT_EQ(two->size(), 2u);
    glm::dvec3 reached(0.0);
    for (const auto& [column, x] : *two) {
        reached += x * columns[column];
    }
    EXPECT_LE(glm::distance(reached, glm::dvec3(1, 4, 0)), 1e-12);
    EXPECT_FALSE(sparse_step(columns, {0, 0, 1}, values, 1e-9));
    EXPECT_FALSE(sparse_step({}, {0, 0, 1}, {}, 1e-9));
}

TEST(MoveLeaf, WrapsWhatHasNoPlaceOfItsOwn) {
    const Moved cube = move("cube(3);", 0, {1, 2, 0.5});
    ASSERT_EQ(cube.ways.size(), 1u);
    EXPECT_EQ(cube.ways.front().kind, Kind::Wrap);
    EXPECT_EQ(cube.text, "translate([1, 2, 0.5]) cube(3);");
    EXPECT_EQ(moved_text("rotate([0, 0, 90]) cube(3);", {1, 0, 0}),
              "rotate([0, 0, 90]) translate([0, -1, 0]) cube(3);");
    // Of a library: what calls it is wrapped, and the library stays as it is.
    const Moved screw = move("use <lib.scad>\nscrew();", 0, {0, 0, 4}, {{"lib.scad", "module screw() cylinder(5);"}});
    ASSERT_EQ(screw.ways.size(), 1u);
    EXPECT_EQ(screw.text, "use <lib.scad>\ntranslate([0, 0, 4]) screw();");
}

TEST(MoveLeaf, TellsWhatElseMoves) {
    const std::string text =
        "step = 10;\nfor (i = [0 : 3]) translate([i * step, 0, 0]) cube(1);\ntranslate([0, 5, 0]) cube(1);\n";
    const Moved second = move(text, 1, {2, 0, 0});
    ASSERT_GE(second.ways.size(), 2u);
    for (const MoveWay& way : second.ways) {
        if (way.kind == Kind::Variable) {
            EXPECT_EQ(way.moved, 3u);  // The first stays at 0.
        } else {
            EXPECT_EQ(way.moved, 4u);
        }
        EXPECT_EQ(way.changed, 0u);
    }
    // Numbers that make the shape as well are no way to move it.
    const Moved tied = move("s = 4;\ntranslate([s, 0, 0]) cube(s);", 0, {1, 0, 0});
    ASSERT_FALSE(tied.ways.empty());
    EXPECT_EQ(tied.ways.front().kind, Kind::Wrap);
    // What the first of two calls is moved by moves one, by the module's body both.
    const Moved called =
        move("module m() translate([0, 0, 1]) cube(1);\ntranslate([5, 0, 0]) m();\nm();", 0, {1, 0, 0});
    EXPECT_EQ(called.ways.front().moved, 1u);
    EXPECT_EQ(called.text, "module m() translate([0, 0, 1]) cube(1);\ntranslate([6, 0, 0]) m();\nm();");
    EXPECT_EQ(called.ways.back().moved, 2u);
}

TEST(TextEdit, IsOfThoseBytesOnly) {
    EXPECT_EQ(edited("abcdef", {{{4, 5}, "X"}, {{0, 0}, "<"}, {{1, 3}, ""}}), "<adXf");
    EXPECT_EQ(short_number(0.30000000000000004, 1e-9), "0.3");
    EXPECT_EQ(short_number(-1e-12, 1e-9), "0");
    EXPECT_EQ(short_number(1234.5, 1e-9), "1234.5");
    EXPECT_EQ(short_number(2, 0), "2");
}

}  // namespace
}  // namespace ui
