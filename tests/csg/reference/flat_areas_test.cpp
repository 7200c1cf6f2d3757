// Flat areas of a surface have the triangles that their outlines need, and no more.
#include "csg/reference/flat_areas.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "csg/reference/boolean.h"
#include "tests/csg/reference/meshes.h"

namespace {

using csg::reference::Mesh;

std::size_t triangles(const std::string& program) {
    const auto mesh = ui::make_mesh(*meshes::model_of(program), {});
    EXPECT_TRUE(mesh.facts.manifold) << program;
    return mesh.mesh.triangles.size();
}

TEST(FlatAreas, OfBooleansHaveWhatTheirOutlinesNeed) {
    EXPECT_EQ(triangles("difference() { cube(10); translate([2, 2, -1]) cube([3, 3, 20]); }"), 2 * 8 + 8 * 2u);
    // Three faces of each lose a corner.
    EXPECT_EQ(triangles("cube(10); translate([5, 5, 5]) cube(10);"), 2 * (3 * 2 + 3 * 4u));
    // A slot, and what cuts its walls up and takes nothing away.
    EXPECT_EQ(triangles("difference() { cube([30, 10, 10]); translate([-1, 4, 8]) cube([40, 2, 9]);"
                        "translate([5, 4, 8.5]) cube([3, 2, 5]); translate([12, 4.5, 8]) cube([3, 1, 5]); }"),
              2 * 6 + 8 * 2u);
}

TEST(FlatAreas, OfDifferentLeavesStayApart) {
    // Flush; the line between them has no points of its own.
    EXPECT_EQ(triangles("cube([4, 4, 2]); translate([4, 0, 0]) cube([4, 4, 2]);"), 2 * (4 * 2 + 2u));
}

TEST(FlatAreas, PointsThatTellTouchingSheetsApartStay) {
    // Two pillars touch along an edge, between plates that hold both. A bar is cut from the one; where it begins within
    // the other it cuts the face beside that edge up, and changes nothing.
    const auto pillars = [](double bar_begins) {
        return fmt::format(
            "cube([4, 4, 9]); cube([8, 8, 1]); translate([0, 0, 8]) cube([8, 8, 1]); difference() {{"
            "translate([4, 4, 0]) cube([4, 4, 9]); translate([3, 1, 3]) rotate(45) translate([{}, -0.5, 0])"
            "cube([{}, 1, 3]); }}",
            bar_begins, 6 - bar_begins);
    };
    EXPECT_EQ(triangles(pillars(0.5)), triangles(pillars(3)));
}

/// Over the outline of points in the plane, from z = 0 to 1. Kinds: 0 below, 1 above, and around 2 + `walls[i]` behind
/// point i.
Mesh prism(const std::vector<glm::dvec2>& outline, const std::vector<std::uint32_t>& walls) {
    Mesh mesh;
    const auto n = static_cast<std::uint32_t>(outline.size());
    for (const double z : {0.0, 1.0}) {
        for (const glm::dvec2& p : outline) {
            mesh.points.emplace_back(p, z);
        }
    }
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t kind) {
        mesh.triangles.emplace_back(a, b, c);
        mesh.sources.push_back(kind);
    };
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        if (i > 0 && j > 0) {
            add(0, j, i, 0);
            add(n, n + i, n + j, 1);
        }
        add(i, j, n + j, 2 + walls[i]);
        add(i, n + j, n + i, 2 + walls[i]);
    }
    return mesh;
}

TEST(FlatAreas, PointsOnStraightLinesGoOnBothSides) {
    std::vector<glm::dvec2> outline;
    for (int i = 0; i < 8; ++i) {
        outline.emplace_back(i * 0.125, 0.0);
    }
    outline.insert(outline.end(), {{1, 0}, {1, 1}, {0, 1}});
    Mesh mesh = prism(outline, {0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3});
    const std::vector<glm::dvec3> normals{{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    csg::reference::merge_flat_areas(mesh, normals);
    EXPECT_EQ(mesh.points.size(), 8u);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    const csg::reference::MeshFacts facts = csg::reference::facts(mesh);
    EXPECT_TRUE(facts.manifold);
    EXPECT_DOUBLE_EQ(facts.volume, 1);
}

TEST(FlatAreas, LinesThatBendSlowlyKeepTheirShape) {
    // Next to its neighbors, each point of the arc lies on a straight line but for rounding.
    std::vector<glm::dvec2> outline;
    constexpr int kPoints = 2000;
    constexpr double kSag = 1e-9;
    for (int i = 0; i <= kPoints; ++i) {
        const double x = static_cast<double>(i) / kPoints;
        outline.emplace_back(x, -4 * kSag * x * (1 - x));
    }
    outline.emplace_back(0.5, 1.0);
    std::vector<std::uint32_t> walls(kPoints, 0);
    walls.insert(walls.end(), {1, 2});
    Mesh mesh = prism(outline, walls);
    const double volume = csg::reference::facts(mesh).volume;
    const std::vector<glm::dvec3> normals{{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {2, 1, 0}, {-2, 1, 0}};
    csg::reference::merge_flat_areas(mesh, normals);
    const csg::reference::MeshFacts facts = csg::reference::facts(mesh);
    EXPECT_TRUE(facts.manifold);
    EXPECT_LT(mesh.points.size(), 1000u);
    EXPECT_NEAR(facts.volume, volume, 1e-13) << "the arc holds 7e-10";
}

TEST(FlatAreas, OfAMeshThatIsNotClosedStayAsTheyAre) {
    Mesh mesh = prism({{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}}, {0, 0, 0, 0, 0});
    mesh.triangles.pop_back();
    mesh.sources.pop_back();
    const Mesh before = mesh;
    csg::reference::merge_flat_areas(mesh, std::vector<glm::dvec3>(3, {0, 0, 1}));
    EXPECT_EQ(mesh.triangles, before.triangles);
    EXPECT_EQ(mesh.points, before.points);
}

}  // namespace
