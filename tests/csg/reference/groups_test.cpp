// Leaves that have nothing to do with each other are combined apart: the same solid, in time that grows with them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "csg/reference/leaf_groups.h"
#include "tests/csg/reference/membership.h"
#include "tests/csg/reference/meshes.h"

namespace {

std::size_t count_groups(const ui::Model& model) {
    std::vector<csg::LeafId> leaves;
    for (csg::LeafId i = 0; i < model.geometry.leaves.size(); ++i) {
        if (!model.geometry.leaves[i].triangles.empty()) {
            leaves.push_back(i);
        }
    }
    return csg::reference::LeafGroups(model.scene, model.geometry, leaves, {}).size();
}

struct Grouped {
    const char* name;
    const char* program;
    std::size_t groups;
    double volume;
    const char* method;
};

void PrintTo(const Grouped& g, std::ostream* out) {
    *out << g.name;
}

class Groups : public testing::TestWithParam<Grouped> {};

TEST_P(Groups, AreFoundAndCombined) {
    const auto model = meshes::model_of(GetParam().program);
    EXPECT_EQ(count_groups(*model), GetParam().groups);
    const ui::ModelMesh mesh = ui::make_mesh(*model);
    EXPECT_TRUE(mesh.facts.manifold);
    EXPECT_NEAR(mesh.facts.volume, GetParam().volume, 1e-9 * GetParam().volume);
    EXPECT_EQ(mesh.method, GetParam().method) << mesh.reason;
    const auto facts = csg::reference::facts(mesh.mesh);
    EXPECT_EQ(facts.components, mesh.facts.components);
    EXPECT_EQ(facts.genus, mesh.facts.genus);
    EXPECT_NEAR(facts.area, mesh.facts.area, 1e-9 * facts.area);
    EXPECT_EQ(facts.box, mesh.facts.box);
}

constexpr Grouped kGrouped[] = {
    {"Apart", "for (x = [0:9], y = [0:9]) translate(2 * [x, y, 0]) cube(1);", 100, 100, "copy"},
    {"Touching", "for (x = [0:9], y = [0:9]) translate([x, y, 0]) cube(1);", 1, 100, "planes"},
    {"Pairs", "for (x = [0:9]) translate([3 * x, 0, 0]) { cube(1); translate([.5, .5, .5]) cube(1); }", 10, 18.75,
     "planes"},
    {"NestedUnions", "module row(n) { cube(1); if (n > 1) translate([2, 0, 0]) row(n - 1); } row(50);", 50, 50, "copy"},
    {"OneLongCutter",
     "difference() { for (x = [0:9]) translate([2 * x, 0, 0]) cube(1); translate([-1, .25, .25]) "
     "cube([30, .5, .5]); }",
     10, 7.5, "planes"},
    {"OwnCutters",
     "for (x = [0:9]) translate([2 * x, 0, 0]) difference() { cube(1); translate([.5, .5, .5]) cube(9); }", 10, 8.75,
     "planes"},
    {"CutterAside", "difference() { cube(1); translate([5, 5, 5]) cube(1); }", 1, 1, "copy"},
    {"CutterAboveCutter",
     "difference() { for (x = [0, 4]) translate([x, 0, 0]) cube(2); difference() { translate([-1, "
     "-1, 1]) cube([20, 20, 3]); translate([4, 0, 0]) cube(2); } }",
     2, 12, "planes"},
    {"AnIntersectionCutsDown",
     "intersection() { union() { for (x = [0:9]) translate([2 * x, 0, 0]) cube(1); } union() "
     "{ for (x = [0, 3]) translate([2 * x, 0, 0]) cube([1, 1, .5]); } }",
     4, 1, "planes"},
    {"AnIntersectionOfUnions",
     "intersection() { union() { for (x = [0:9]) translate([2 * x, 0, 0]) cube(1); } "
     "translate([-1, 0, 0]) cube([30, 1, .5]); }",
     1, 5, "planes"},
    {"NothingInCommon", "intersection() { cube(1); translate([3, 0, 0]) cube(1); } translate([9, 0, 0]) cube(1);", 1, 1,
     "copy"},
    {"Colors", "for (x = [0:9]) translate([2 * x, 0, 0]) color([x / 10, 0, 0, x / 10]) cube(1);", 10, 10, "copy"},
    {"Mirrored", "for (x = [0:9]) translate([3 * x, 0, 0]) mirror([1, 1, 0]) cylinder(h = 2, r1 = 1, r2 = 0, $fn = 4);",
     10, 40.0 / 3, "copy"},
};

INSTANTIATE_TEST_SUITE_P(Scenes, Groups, testing::ValuesIn(kGrouped), [](const auto& info) { return info.param.name; });

/// A polyhedron of boxes [lo, hi]; turned inside out where lo > hi.
std::string shells(const std::string& boxes) {
    return "boxes = " + boxes +
           "; polyhedron([for (b = boxes, k = [0:7]) [b[k % 2].x, b[floor(k / 2) % 2].y, b[floor(k / 4)].z]], [for (i "
           "= "
           "[0:len(boxes) - 1], f = [[0,1,3,2],[4,6,7,5],[0,4,5,1],[2,3,7,6],[0,2,6,4],[1,5,7,3]]) [for (k = f) k + 8 "
           "* "
           "i]]);";
}

constexpr Grouped kShells[] = {
    {"Apart", "[for (i = [0:99]) [[2 * i, 0, 0], [2 * i + 1, 1, 1]]]", 100, 100, "copy"},
    {"Cavities", "[for (i = [0:9]) each [[[4 * i, 0, 0], [4 * i + 3, 3, 3]], [[4 * i + 2, 2, 2], [4 * i + 1, 1, 1]]]]",
     10, 260, "planes"},
    {"Twice", "[for (i = [0:9]) each [[[4 * i, 0, 0], [4 * i + 3, 3, 3]], [[4 * i, 0, 0], [4 * i + 3, 3, 3]]]]", 10,
     270, "planes"},
    {"InsideOut", "[for (i = [0:9]) [[2 * i + 1, 1, 1], [2 * i, 0, 0]]]", 10, 10, "planes"},
    {"SharingAnEdge", "[for (i = [0, 1]) [[i, i, 0], [i + 1, i + 1, 1]]]", 1, 2, "planes"},
};

class ShellGroups : public testing::TestWithParam<Grouped> {};

TEST_P(ShellGroups, AreTakenApart) {
    const auto model = meshes::model_of(shells(GetParam().program));
    EXPECT_EQ(count_groups(*model), GetParam().groups);
    const ui::ModelMesh mesh = ui::make_mesh(*model);
    EXPECT_TRUE(mesh.facts.manifold);
    EXPECT_NEAR(mesh.facts.volume, GetParam().volume, 1e-9 * GetParam().volume);
    EXPECT_EQ(mesh.method, GetParam().method) << mesh.reason;
}

INSTANTIATE_TEST_SUITE_P(Leaves, ShellGroups, testing::ValuesIn(kShells),
                         [](const auto& info) { return info.param.name; });

TEST(Groups, EachLeafKeepsItsTriangles) {
    const auto model = meshes::model_of("for (x = [0:9]) translate([2 * x, 0, 0]) cube(1);");
    const ui::ModelMesh mesh = ui::make_mesh(*model);
    for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
        EXPECT_EQ(mesh.mesh.sources[t], t / 12);
    }
}

TEST(Groups, OneBesideADifficultOneIsCopied) {
    const auto model = meshes::model_of(
        "translate([-500, 0, 0]) cube(1); difference() { rotate([17.3, 29.1, 41.7]) cube([9999, 0.1, 3]); sphere(1); "
        "rotate([3, 4, 5]) cube(2); }");
    const ui::ModelMesh mesh = ui::make_mesh(*model);
    EXPECT_TRUE(mesh.facts.manifold);
    EXPECT_EQ(std::count(mesh.mesh.sources.begin(), mesh.mesh.sources.end(), 0u), 12);
}

/// Surfaces that meet themselves are combined with themselves.
TEST(Groups, WhatIsCopiedMeetsItselfNowhere) {
    const char* const programs[] = {
        // Two triangular prisms that share an edge's inside; a strip folded flat; a spike through the opposite wall.
        "linear_extrude(2) polygon([[0,0],[10,10],[10,0],[0,9]]);",
        "polyhedron([[0,0,0],[4,0,0],[0,4,0],[1,1,3],[1,1,-1]], [[0,2,1],[0,1,3],[1,2,3],[2,0,3]]);",
        "polyhedron([[0,0,0],[4,0,0],[4,4,0],[0,4,0],[2,2,2],[2,2,-1]], "
        "[[0,1,4],[1,2,4],[2,3,4],[3,0,4],[1,0,5],[2,1,5],[3,2,5],[0,3,5]]);",
        "polyhedron([[0,0,0],[4,0,0],[4,4,0],[0,4,0],[2,2,2],[2,2,3]], "
        "[[0,1,4],[1,2,4],[2,3,4],[3,0,4],[1,0,5],[2,1,5],[3,2,5],[0,3,5]]);",
        "polyhedron([[0,0,0],[4,0,0],[4,4,0],[0,4,0],[2,2,-2],[9,2,3]], "
        "[[0,1,4],[1,2,4],[2,3,4],[3,0,4],[1,0,5],[2,1,5],[3,2,5],[0,3,5]]);",
    };
    for (const char* program : programs) {
        const auto model = meshes::model_of(program);
        csg::reference::BooleanRequest exact;
        exact.method = csg::reference::Method::Exact;
        const auto found = csg::reference::make_mesh(model->scene, model->geometry),
                   sure = csg::reference::make_mesh(model->scene, model->geometry, exact);
        EXPECT_NEAR(found.facts.volume, sure.facts.volume, 1e-9 * sure.facts.volume) << program;
        EXPECT_NEAR(found.facts.area, sure.facts.area, 1e-6 * sure.facts.area) << program;
    }
}

/// Random expressions of boxes and balls far apart and near: points inside by definition are inside the mesh.
TEST(Groups, RandomScenesHoldThePointsTheyShould) {
    std::mt19937 random(7);
    const auto number = [&](double lo, double hi) {
        return lo + (hi - lo) * (static_cast<double>(random()) / 4294967296.0);
    };
    const auto leaf = [&] {
        const double size = random() % 5 == 0 ? number(4, 20) : number(1, 3);
        const std::string shape = random() % 3 == 0
                                      ? fmt::format("sphere({:.2f}, $fn = 8)", size / 2)
                                      : fmt::format("cube([{:.2f}, {:.2f}, {:.2f}])", size, number(1, 3), number(1, 3));
        return fmt::format("translate([{:.2f}, {:.2f}, {:.2f}]) {};", number(0, 20), number(0, 20), number(0, 4),
                           shape);
    };
    const std::function<std::string(int)> tree = [&](int depth) -> std::string {
        if (depth == 0 || random() % 6 == 0) {
            return leaf();
        }
        static constexpr const char* kKinds[] = {"union", "union", "difference", "intersection"};
        std::string text = kKinds[random() % 4] + std::string("() {");
        for (std::size_t i = 0, n = 2 + random() % 5; i < n; ++i) {
            text += tree(depth - 1);
        }
        return text + "}";
    };
    std::size_t solids = 0, several = 0;
    for (int i = 0; i < 100; ++i) {
        const std::string program = tree(3) + tree(2) + tree(2);
        const auto model = meshes::model_of(program);
        const auto found = csg::reference::make_mesh(model->scene, model->geometry);
        if (found.mesh.empty()) {
            continue;
        }
        ++solids;
        several += count_groups(*model) > 1 ? 1 : 0;
        EXPECT_EQ(meshes::count_wrong_points(model->scene, model->geometry, found.mesh, model->geometry.box, 300), 0u)
            << program;
    }
    EXPECT_GT(solids, 80u);
    EXPECT_GT(several, 50u);
}

TEST(Groups, ManyTouchingLeavesTakeTimeInProportion) {
    const ui::ModelMesh mesh =
        ui::make_mesh(*meshes::model_of("for (x = [0:15], y = [0:15], z = [0:15]) translate([x, y, z]) cube(1);"));
    EXPECT_NEAR(mesh.facts.volume, 4096, 1e-6);
    EXPECT_EQ(mesh.facts.components, 1u);
}

}  // namespace
