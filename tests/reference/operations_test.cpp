// Hull, Minkowski sum and projection against closed forms.
#include <gtest/gtest.h>

#include "csg/reference/hull.h"
#include "csg/reference/mesh_boolean.h"
#include "csg/reference/nef.h"
#include "csg/reference/projection.h"
#include "csg/reference/self_intersection.h"
#include "tests/reference/meshes.h"

namespace {

using csg::reference::Mesh;

Mesh mesh_of(const std::string& program) {
    return ui::make_mesh(*meshes::model_of(program)).mesh;
}

double volume(const Mesh& mesh) {
    const auto facts = csg::reference::facts(mesh);
    EXPECT_TRUE(facts.manifold);
    return facts.volume;
}

TEST(Hull, OfPoints) {
    const std::vector<glm::dvec3> points{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0.1, 0.1, 0.1}, {1, 0, 0}};
    const Mesh hull = csg::reference::hull(points);
    EXPECT_NEAR(volume(hull), 8.0 / 6, 1e-12);
    EXPECT_TRUE(csg::reference::convex(hull));
}

TEST(Hull, OfTwoCubes) {
    EXPECT_NEAR(volume(csg::reference::hull(mesh_of("cube(1); translate([4, 0, 0]) cube(1);").points)), 5, 1e-12);
}

TEST(Hull, FlatPointsHaveNone) {
    EXPECT_TRUE(csg::reference::hull({}).empty());
    EXPECT_TRUE(csg::reference::hull(std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).empty());
    EXPECT_TRUE(csg::reference::hull(std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).empty());
    EXPECT_TRUE(csg::reference::hull(std::vector<glm::dvec3>(5, {1, 2, 3})).empty());
}

TEST(Hull, ConvexIsDecided) {
    EXPECT_TRUE(csg::reference::convex(mesh_of("cube(1);")));
    EXPECT_FALSE(csg::reference::convex(mesh_of("difference() { cube(2); translate([1, 1, 1]) cube(2); }")));
    EXPECT_FALSE(csg::reference::convex(mesh_of("cube(1); translate([3, 0, 0]) cube(1);")));
}

TEST(Minkowski, OfConvexMeshes) {
    const Mesh operands[] = {mesh_of("cube([1, 2, 3]);"), mesh_of("cube(1);"), mesh_of("cube(1);")};
    EXPECT_NEAR(volume(csg::reference::minkowski_sum(operands)), 3.0 * 4 * 5, 1e-12);
}

TEST(Minkowski, OfAnL) {
    // The L grows by one to the right and up, into its notch too.
    const Mesh operands[] = {mesh_of("difference() { cube([4, 4, 1]); translate([2, 2, -1]) cube([3, 3, 3]); }"),
                             mesh_of("cube(1);")};
    EXPECT_NEAR(volume(csg::reference::minkowski_sum(operands)), (25.0 - 4) * 2, 1e-9);
}

TEST(Projection, Shadow) {
    EXPECT_NEAR(csg::reference::projection(mesh_of("cube([2, 3, 4]);"), false).area(), 6, 1e-12);
    const auto ring = csg::reference::projection(
        mesh_of("difference() { cube(4, center = true); cube([2, 2, 9], center = true); }"), false);
    EXPECT_NEAR(ring.area(), 12, 1e-12);
    EXPECT_EQ(ring.loops.size(), 2u);
    EXPECT_NEAR(csg::reference::projection(mesh_of("cube(2); translate([1, 1, 5]) cube(2);"), false).area(), 7, 1e-12);
}

TEST(Projection, Cut) {
    EXPECT_NEAR(csg::reference::projection(mesh_of("translate([0, 0, -1]) cube([2, 3, 4]);"), true).area(), 6, 1e-12);
    EXPECT_TRUE(csg::reference::projection(mesh_of("translate([0, 0, 1]) cube(2);"), true).loops.empty());
    const auto ring = csg::reference::projection(
        mesh_of("difference() { cube(4, center = true); cube([2, 2, 9], center = true); }"), true);
    EXPECT_NEAR(ring.area(), 12, 1e-12);
    EXPECT_EQ(ring.loops.size(), 2u);
}

TEST(MeshBooleans, OfPlainMeshes) {
    using csg::ExpressionKind;
    const Mesh operands[] = {mesh_of("cube(4);"), mesh_of("translate([2, 0, 0]) cube(4);"),
                             mesh_of("translate([1, 1, -1]) cube([1, 1, 9]);")};
    EXPECT_NEAR(volume(csg::reference::combine(ExpressionKind::Union, operands).mesh), 96 + 5, 1e-12);
    EXPECT_NEAR(volume(csg::reference::combine(ExpressionKind::Difference, operands).mesh), 32 - 4, 1e-12);
    EXPECT_TRUE(csg::reference::combine(ExpressionKind::Intersection, operands).mesh.empty());
    EXPECT_TRUE(csg::reference::combine(ExpressionKind::Union, {}).mesh.empty());
}

TEST(SelfIntersection, IsFound) {
    Mesh mesh = mesh_of("cube(2);");
    EXPECT_EQ(csg::reference::count_self_intersections(mesh, 1e-9), 0u);
    // A second cube put over it without a union.
    const Mesh other = mesh_of("translate([1, 0.9, 1.1]) cube(2);");
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
    for (const glm::uvec3& t : other.triangles)
        mesh.triangles.push_back(t + first);
    EXPECT_GT(csg::reference::count_self_intersections(mesh, 1e-9), 0u);
}

}  // namespace
