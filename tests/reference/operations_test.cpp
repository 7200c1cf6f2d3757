// Hull, Minkowski sum and projection against closed forms.
#include <gtest/gtest.h>

#include <algorithm>

#include "csg/reference/hull.h"
#include "csg/reference/mesh_boolean.h"
#include "csg/reference/minkowski.h"
#include "csg/reference/self_intersection.h"
#include "csg/solid/node_geometry.h"
#include "tests/reference/meshes.h"

namespace {

using csg::reference::Mesh;
namespace solid = csg::solid;

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

TEST(Minkowski, OfABallThatIsConvexButForRounding) {
    // A box and a ball of OpenSCAD's: faces, edges and corners as Steiner's formula has them, with the ball's own
    // mean width in place of the sphere's. Decomposed in exact arithmetic this took half a minute.
    const Mesh ball = mesh_of("sphere(2, $fn = 40);");
    const Mesh operands[] = {mesh_of("cube([8, 6, 4], center = true);"), ball};
    const auto facts = csg::reference::facts(ball);
    const Mesh sum = csg::reference::minkowski_sum(operands);
    const glm::dvec3 size = facts.box.size(), box(8, 6, 4);
    // Of a centrally symmetric body K: V(B + K) = V(B) + sum of face areas times width / 2 twice + edges times the
    // area of K's shadow along them + V(K).
    const auto shadow_along = [&](const char* turn) {
        Mesh mesh = mesh_of(std::string("rotate(") + turn + ") sphere(2, $fn = 40);");
        const solid::Mesh plain{std::move(mesh.points), std::move(mesh.triangles)};
        return solid::shadow(std::span(&plain, 1)).area();
    };
    const double expected = box.x * box.y * box.z + box.y * box.z * size.x + box.x * box.z * size.y +
                            box.x * box.y * size.z + box.x * shadow_along("[0, 90, 0]") +
                            box.y * shadow_along("[90, 0, 0]") + box.z * shadow_along("[0, 0, 0]") + facts.volume;
    EXPECT_NEAR(volume(sum), expected, 1e-9 * expected);
}

TEST(Minkowski, OfCubesThatTouchAtACorner) {
    const Mesh operands[] = {mesh_of("cube(2); translate([2, 2, 2]) cube(2);"), mesh_of("cube(1);")};
    // Two cubes of 3 that share a cube of 1.
    EXPECT_NEAR(volume(csg::reference::minkowski_sum(operands)), 27 + 27 - 1, 1e-9);
}

TEST(Minkowski, OfCubesThatTouchAlongAnEdge) {
    const Mesh operands[] = {mesh_of("cube(2); translate([2, 2, 0]) cube(2);"), mesh_of("cube(1);")};
    // Two cubes of 3 that share a bar of 1 by 1.
    EXPECT_NEAR(volume(csg::reference::minkowski_sum(operands)), 27 + 27 - 3, 1e-9);
    // The same where the cubes share the corners of the edge, which is then one edge of four faces.
    Mesh touching = mesh_of("cube(2);");
    const Mesh second = mesh_of("translate([2, 2, 0]) cube(2);");
    std::vector<std::uint32_t> index;
    for (const glm::dvec3& p : second.points) {
        const auto known = std::find(touching.points.begin(), touching.points.end(), p);
        index.push_back(static_cast<std::uint32_t>(known - touching.points.begin()));
        if (known == touching.points.end())
            touching.points.push_back(p);
    }
    for (const glm::uvec3& t : second.triangles)
        touching.triangles.emplace_back(index[t.x], index[t.y], index[t.z]);
    ASSERT_EQ(touching.points.size(), 14U);
    const Mesh shared[] = {touching, operands[1]};
    EXPECT_NEAR(volume(csg::reference::minkowski_sum(shared)), 27 + 27 - 3, 1e-9);
}

TEST(Minkowski, OfAHollowCube) {
    const Mesh operands[] = {mesh_of("difference() { cube(9, center = true); cube(5, center = true); }"),
                             mesh_of("cube(1, center = true);")};
    EXPECT_NEAR(volume(csg::reference::minkowski_sum(operands)), 1000 - 64, 1e-9);
}

solid::Outline shadow(const std::string& program) {
    Mesh mesh = mesh_of(program);
    const solid::Mesh plain{std::move(mesh.points), std::move(mesh.triangles)};
    return solid::shadow(std::span(&plain, 1));
}

solid::Outline cut(const std::string& program) {
    Mesh mesh = mesh_of(program);
    const solid::Piece piece{solid::to_solid({std::move(mesh.points), std::move(mesh.triangles)}, true), nullptr};
    return solid::cut(std::span(&piece, 1));
}

TEST(Projection, Shadow) {
    EXPECT_NEAR(shadow("cube([2, 3, 4]);").area(), 6, 1e-12);
    const auto ring = shadow("difference() { cube(4, center = true); cube([2, 2, 9], center = true); }");
    EXPECT_NEAR(ring.area(), 12, 1e-12);
    EXPECT_EQ(ring.loops.size(), 2u);
    EXPECT_NEAR(shadow("cube(2); translate([1, 1, 5]) cube(2);").area(), 7, 1e-12);
}

TEST(Projection, Cut) {
    EXPECT_NEAR(cut("translate([0, 0, -1]) cube([2, 3, 4]);").area(), 6, 1e-12);
    EXPECT_TRUE(cut("translate([0, 0, 1]) cube(2);").loops.empty());
    const auto ring = cut("difference() { cube(4, center = true); cube([2, 2, 9], center = true); }");
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
