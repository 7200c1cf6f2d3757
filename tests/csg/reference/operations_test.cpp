// Hull, Minkowski sum and projection against closed forms.
#include <gtest/gtest.h>

#include <algorithm>

#include "csg/reference/hull.h"
#include "csg/reference/mesh_boolean.h"
#include "csg/reference/minkowski.h"
#include "csg/reference/self_intersection.h"
#include "csg/solid/node_geometry.h"
#include "tests/csg/reference/meshes.h"

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
        if (known == touching.points.end()) {
            touching.points.push_back(p);
        }
    }
    for (const glm::uvec3& t : second.triangles) {
        touching.triangles.emplace_back(index[t.x], index[t.y], index[t.z]);
    }
    touching.sources.resize(touching.triangles.size());
    ASSERT_EQ(touching.points.size(), 14U);
    const Mesh shared[] = {touching, operands[1]};
    EXPECT_NEAR(volume(csg::reference::minkowski_sum(shared)), 27 + 27 - 3, 1e-9);
}

TEST(Minkowski, OfAHollowCube) {
    const Mesh operands[] = {mesh_of("difference() { cube(9, center = true); cube(5, center = true); }"),
                             mesh_of("cube(1, center = true);")};
    EXPECT_NEAR(volume(csg::reference::minkowski_sum(operands)), 1000 - 64, 1e-9);
}

TEST(Minkowski, OfPrismsWithAHole) {
    // Along z the sum is that of the outlines.
    const std::string module =
        "$fs = .5; module p() offset(3) square([51, 41], center = true);"
        "module q() difference() { p(); translate([26, 21]) circle(6); } ";
    const Mesh sum = mesh_of(module +
                             "minkowski() { union() { linear_extrude(6.4) p(); linear_extrude(31.8) q(); } "
                             "cube(1); }");
    const Mesh expected = mesh_of(module +
                                  "module o() minkowski() { children(); square(1); } "
                                  "linear_extrude(7.4) o() p(); linear_extrude(32.8) o() q();");
    EXPECT_NEAR(volume(sum), volume(expected), 1e-9 * volume(expected));
}

TEST(Minkowski, OfPrismsIsASumInThePlane) {
    // No face is cut up where flat things meet, whatever the disc's height, and along any axis.
    const std::string plate =
        "difference() { cube([40, 30, 4]); for (x = [6 : 7 : 34], y = [6 : 6 : 24]) translate([x, y, -1]) "
        "cylinder(r = 2, h = 9, $fn = 24); translate([-1, 12, 2]) cube([50, 3, 5]); }";
    const Mesh plane = mesh_of("minkowski() { " + plate + " cylinder(r = 0.5, h = 1, $fn = 16); }");
    const Mesh thin = mesh_of("minkowski() { " + plate + " cylinder(r = 0.5, h = 1e-7, $fn = 16); }");
    const Mesh turned = mesh_of("minkowski() { rotate([90, 0, 0]) " + plate +
                                " rotate([90, 0, 0]) cylinder(r = 0.5, h = 1, $fn = 16); }");
    EXPECT_LT(plane.triangles.size(), 4000u);
    EXPECT_LT(thin.triangles.size(), 4000u);
    EXPECT_NEAR(volume(turned), volume(plane), 1e-9 * volume(plane));
    // The hole is smaller by the disc on all sides, and the slot by its height and width.
    EXPECT_NEAR(volume(mesh_of("minkowski() { difference() { cube([9, 9, 4]); translate([2, 2, -1]) cube([5, 5, 9]); "
                               "translate([-1, 4, 2]) cube([20, 1.5, 9]); } cube([1, 1, 0.5]); }")),
                100 * 4.5 - 16 * 4.5 - 0.5 * 6 * 2, 1e-9);
}

TEST(Minkowski, OfARoundedBoxHasNoMoreFacesThanItsSurface) {
    const Mesh box = mesh_of(
        "minkowski() { difference() { cube([60, 40, 20]); translate([3, 3, 3]) cube([54, 34, 20]);"
        " } sphere(r = 1.5, $fn = 32); }");
    EXPECT_LT(box.triangles.size(), 1300u);
    EXPECT_NEAR(volume(box), 35015.86964581893, 1e-8);
    // The complement grown: facets of both at angles to each other.
    const Mesh grown = mesh_of(
        "$fn = 8; minkowski() { difference() { translate([-4, -4, -4]) cube(32); union() { sphere(5); translate([6, 0, "
        "0]) rotate([10, 20, 30]) sphere(5); } } sphere(1); }");
    EXPECT_LT(grown.triangles.size(), 1000u);
    EXPECT_NEAR(volume(grown), 38265.812305022, 1e-8);
}

TEST(Minkowski, OfFineBallsFormsNotAllSums) {
    // Alike, so the sum is the ball of both radii; all sums would be 25 million.
    EXPECT_NEAR(volume(mesh_of("minkowski() { sphere(10, $fn = 100); sphere(1, $fn = 100); }")),
                volume(mesh_of("sphere(11, $fn = 100);")), 1e-6);
}

TEST(Minkowski, OfAComplementTwice) {
    EXPECT_NEAR(volume(mesh_of(R"($fn = 8;
        module cap(a, b) hull() { translate(a) sphere(2); translate(b) sphere(2); }
        module lat() { cap([0,0,0], [20,0,0]); cap([0,0,0], [0,20,0]); cap([0,0,0], [0,0,20]); cap([20,0,0], [0,20,0]); }
        difference() {
            translate([-3,-3,-3]) cube([28,28,20]);
            minkowski() {
                difference() { translate([-4,-4,-4]) cube(32); minkowski() { lat(); sphere(1); } }
                sphere(1);
            }
        })")),
                898.5796, 1e-3);  // OpenSCAD: 898
}

TEST(Minkowski, OfAPlateWithHardlyAVolume) {
    // A square and a diamond: 4 + 8 + 2.
    EXPECT_NEAR(volume(mesh_of("minkowski() { cube(2); cylinder(r = 1, h = 1e-7, $fn = 4); }")), 14 * (2 + 1e-7), 1e-7);
}

TEST(Minkowski, OfAnOperandThatFillsTheOthersCavity) {
    // The first of the inner boxes cannot be in the cavity without cutting its walls, the second can.
    EXPECT_NEAR(volume(mesh_of("minkowski() { difference() { cube(30, center = true); cube(20, center = true); } "
                               "difference() { cube(24, center = true); cube(22, center = true); } }")),
                54.0 * 54 * 54, 1e-6);
    EXPECT_NEAR(volume(mesh_of("minkowski() { difference() { cube(30, center = true); cube(20, center = true); } "
                               "difference() { cube(14, center = true); cube(12, center = true); } }")),
                44.0 * 44 * 44 - 6.0 * 6 * 6, 1e-6);
}

TEST(Minkowski, HoldsWhatIsFarFromAnyFace) {
    EXPECT_NEAR(
        volume(mesh_of("minkowski() { difference() { cube(30); translate([20, 20, -1]) cube(40); } cube(1); }")),
        (31.0 * 31 - 10 * 10) * 31, 1e-6);
}

TEST(Minkowski, OfShellsThatOverlapAndOfAMeshInsideOut) {
    Mesh two = mesh_of("cube(4);");
    const Mesh second = mesh_of("translate([2, 2, 2]) cube(4);");
    const auto first = static_cast<std::uint32_t>(two.points.size());
    two.points.insert(two.points.end(), second.points.begin(), second.points.end());
    for (const glm::uvec3& t : second.triangles) {
        two.triangles.push_back(t + first);
    }
    two.sources.resize(two.triangles.size());
    Mesh turned = mesh_of("difference() { cube([4, 4, 1]); translate([2, 2, -1]) cube([3, 3, 3]); }");
    for (glm::uvec3& t : turned.triangles) {
        std::swap(t.y, t.z);
    }
    const Mesh one = mesh_of("cube(1);");
    const Mesh shells[] = {two, one}, inside_out[] = {turned, one};
    EXPECT_NEAR(volume(csg::reference::minkowski_sum(shells)), 125 + 125 - 27, 1e-9);
    EXPECT_NEAR(volume(csg::reference::minkowski_sum(inside_out)), (25.0 - 4) * 2, 1e-9);
}

TEST(Minkowski, FewerPiecesGiveTheSameSum) {
    // So many faces of both that pieces are grown first.
    const std::string ring = "rotate_extrude($fn = 12) translate([3, 0]) circle(1, $fn = 6);";
    const Mesh sum = mesh_of("minkowski() { " + ring + " rotate([90, 0, 0]) " + ring + " }");
    EXPECT_GT(volume(sum), 100);
    EXPECT_EQ(csg::reference::count_self_intersections(sum, 1e-8), 0u);
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
    for (const glm::uvec3& t : other.triangles) {
        mesh.triangles.push_back(t + first);
    }
    mesh.sources.resize(mesh.triangles.size());
    EXPECT_GT(csg::reference::count_self_intersections(mesh, 1e-9), 0u);
}

}  // namespace
