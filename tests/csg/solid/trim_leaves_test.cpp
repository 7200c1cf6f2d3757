// What reaches far beyond a part is cut off, and nothing changes.
#include "csg/solid/trim_leaves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/csg/scad/evaluate_text.h"
#include "tests/csg/solid/mesh_volume.h"

namespace {

csg::solid::Geometry placed(const std::string& model) {
    const test::Run run = test::run(model);
    csg::solid::SolidCache cache;
    return csg::solid::place(*run.evaluation.tree, csg::make_scene(*run.evaluation.tree), cache);
}

/// As often in one direction as in the other.
bool closed(const csg::solid::PlacedLeaf& leaf) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const glm::uvec3& t : leaf.triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            edges[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    }
    return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

TEST(TrimmedLeaves, ThatOnlyTouchTheCutAreGone) {
    // A face of the cutter lies just where it is cut off; one beyond that is cut to nothing as well.
    for (const std::string further : {"0", "1"}) {
        const csg::solid::Geometry geometry =
            placed("difference() { cube(1); translate([1 + 64 * sqrt(3) + " + further + ", 0, 0]) cube(10); }");
        ASSERT_EQ(geometry.leaves.size(), 2u);
        EXPECT_EQ(geometry.leaves[0].triangles.size(), 12u);
        EXPECT_TRUE(geometry.leaves[1].triangles.empty() && geometry.leaves[1].box.empty());
        EXPECT_TRUE(geometry.failures.empty() && geometry.warnings.empty());
        EXPECT_EQ(geometry.box.hi, glm::dvec3(1));
    }
}

TEST(SizesOfLeaves, AreJudgedOnce) {
    const auto failure_of = [](const std::string& model) {
        const csg::solid::Geometry geometry = placed(model + "\ncube(1);");
        EXPECT_EQ(geometry.leaves.back().triangles.size(), 12u) << "the rest is there";
        return geometry.failures.empty() ? "" : geometry.failures.size() == 1 ? geometry.failures[0] : "several";
    };
    const auto contains = [&](const std::string& model, const std::string& text) {
        const std::string failure = failure_of(model);
        EXPECT_NE(failure.find(text), std::string::npos) << model << ": " << failure;
    };
    contains("translate([1e19, 0, 0]) cube(1);", "too thin for double precision");
    contains("scale([1e31, 1, 1]) cube(1);", "its coordinates reach 1e+31");
    contains("translate([1e31, 0, 0]) cube(1);", "too thin for double precision");
    EXPECT_EQ(failure_of("scale([1, 1, 0]) cube(1);"), "");
    EXPECT_EQ(failure_of("cube([1, 1, 0]);"), "");
    EXPECT_EQ(failure_of("polyhedron([[0,0,0],[1,0,0],[0,1,0]], [[0,1,2],[0,2,1]]);"), "") << "nothing from the start";
}

TEST(TrimmedLeaves, AreClosedAndReachAsFarAsTheyMay) {
    const char* const model =
        "difference() {"
        "  cube(4, center = true);"
        "  cylinder(h = 1e10, r = 1, center = true, $fn = 7);"
        "  rotate([20, 30, 0]) cube([1e9, 1, 1], center = true);"
        "  linear_extrude(1e11, center = true) difference() { square(3, center = true); square(1, center = true); }"
        "}";
    const csg::solid::Geometry geometry = placed(model);
    ASSERT_EQ(geometry.leaves.size(), 4u);
    const double reach = csg::solid::kFarthestReach * std::sqrt(48.0) + 2;
    for (const csg::solid::PlacedLeaf& leaf : geometry.leaves) {
        EXPECT_TRUE(closed(leaf));
        EXPECT_EQ(leaf.planes.size(), leaf.triangles.size());
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(leaf.box.hi[axis], reach * (1 + 1e-12));
            EXPECT_GE(leaf.box.lo[axis], -reach * (1 + 1e-12));
        }
    }
    const auto volume = [&](std::size_t leaf) {
        return test::mesh_volume(geometry.leaves[leaf].points, geometry.leaves[leaf].triangles);
    };
    EXPECT_EQ(volume(0), 64);
    EXPECT_NEAR(volume(1), 2 * reach * 3.5 * std::sin(2 * std::acos(-1.0) / 7), 1e-6);
    EXPECT_NEAR(volume(3), 2 * reach * 8, 1e-6) << "a hole goes through the cut";
    EXPECT_LT(geometry.planes.tolerance(), 1e-7);
}

/// Shells that overlap where they are cut off: the caps close each of them.
TEST(TrimmedLeaves, KeepTheirWindingNumbers) {
    const csg::solid::Geometry geometry = placed(
        "difference() { cube(4, center = true); scale([1, 1, 1e9]) polyhedron("
        "[[0, 0, -1], [1, 0, -1], [0, 1, -1], [0, 0, 1], [1, 0, 1], [0, 1, 1],"
        " [0.2, 0.2, -2], [1.2, 0.2, -2], [0.2, 1.2, -2], [0.2, 0.2, 2], [1.2, 0.2, 2], [0.2, 1.2, 2]],"
        "[for (s = [0, 6]) each [[s, s + 1, s + 2], [s + 5, s + 4, s + 3], [s, s + 3, s + 4, s + 1],"
        " [s + 1, s + 4, s + 5, s + 2], [s + 2, s + 5, s + 3, s]]]); }");
    const csg::solid::PlacedLeaf& leaf = geometry.leaves[1];
    EXPECT_TRUE(leaf.solid->winds());
    EXPECT_TRUE(closed(leaf));
    const double height = leaf.box.hi.z - leaf.box.lo.z;
    EXPECT_LT(height, 2000);
    EXPECT_NEAR(test::mesh_volume(leaf.points, leaf.triangles), height, 1e-6) << "two prisms over half a square";
}

TEST(TrimmedLeaves, AreThoseThatReachFarOnly) {
    const csg::solid::Geometry geometry =
        placed("difference() { cube(1); translate([0.2, 0.2, -9]) cube([0.5, 0.5, 50]); }");
    EXPECT_EQ(geometry.leaves[1].box.hi.z, 41);
    EXPECT_EQ(geometry.leaves[1].points.size(), 8u);
    const csg::solid::Geometry endless = placed("cube(1e10); translate([1, 1, 1]) cube(1);");
    EXPECT_EQ(endless.leaves[0].box.hi.z, 1e10) << "what is seen is as large as it is";
}

}  // namespace
