// Which triangles of leaves are one smooth surface.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "csg/solid/extrude.h"
#include "csg/solid/mesh_faces.h"
#include "csg/tree/degrees.h"

namespace {

using namespace csg;
using namespace csg::solid;

Fineness fn(double segments) {
    Fineness fine;
    fine.fn = segments;
    return fine;
}

std::size_t surfaces(const Solid& solid) {
    EXPECT_EQ(solid.groups.size(), solid.triangles.size());
    std::set<std::uint32_t> all;
    for (const FacetGroup& group : solid.groups) {
        all.insert(group.surface());
    }
    return all.size();
}

bool is_crease(const Solid& solid, const MeshEdge& edge) {
    return !smooth_between(solid.groups[edge.triangles[0]], solid.groups[edge.triangles[1]]);
}

/// Edges between faces that are creases, of those for which `counts` holds.
template <typename Counts>
std::size_t creases(const Solid& solid, const Counts& counts) {
    std::size_t count = 0;
    const MeshFaces faces(solid);
    for (const MeshEdge& edge : faces.edges()) {
        count += is_crease(solid, edge) && counts(edge) ? 1U : 0U;
    }
    return count;
}
std::size_t creases(const Solid& solid) {
    return creases(solid, [](const MeshEdge&) { return true; });
}

/// Those that go up.
std::size_t upright_creases(const Solid& solid) {
    return creases(solid, [&](const MeshEdge& edge) {
        return std::abs(solid.points[edge.from].z - solid.points[edge.to].z) > 1e-9;
    });
}

Outline loop_of(Loop loop) {
    return {{std::move(loop)}};
}

Outline circle(double radius, double segments) {
    return make_outline(Circle{radius, fn(segments)});
}

std::shared_ptr<Solid> extruded(const Outline& outline, double twist = 0, std::uint32_t slices = 1) {
    LinearExtrude how;
    how.height = 10;
    how.twist = twist;
    how.slices = slices;
    return linear_extrude(outline, how);
}

/// The same mesh without what is known of it.
Solid estimated(Solid solid) {
    solid.groups.clear();
    estimate_groups(solid);
    return solid;
}
Solid estimated(const LeafShape& shape) {
    return estimated(*make_solid(shape));
}

TEST(SmoothGroups, OfPrimitives) {
    EXPECT_EQ(surfaces(*make_solid(Cube{})), 6U);
    EXPECT_EQ(creases(*make_solid(Cube{})), 12U);
    for (const double n : {8, 12, 48, 100}) {
        const auto cylinder = make_solid(Cylinder{10, 5, 5, false, fn(n)});
        EXPECT_EQ(surfaces(*cylinder), 3U);
        EXPECT_EQ(creases(*cylinder), static_cast<std::size_t>(2 * n));
        EXPECT_EQ(surfaces(*make_solid(Cylinder{10, 5, 0, false, fn(n)})), 2U);
        EXPECT_EQ(surfaces(*make_solid(Cylinder{10, 0, 5, false, fn(n)})), 2U);
        EXPECT_EQ(surfaces(*make_solid(Cylinder{10, 5, 3, false, fn(n)})), 3U);
        EXPECT_EQ(surfaces(*make_solid(Sphere{5, fn(n)})), 1U);
    }
}

TEST(SmoothGroups, AFewSegmentsThatWereAskedForAreCorners) {
    EXPECT_EQ(surfaces(*make_solid(Cylinder{10, 5, 5, false, fn(6)})), 8U);
    EXPECT_EQ(surfaces(*make_solid(Cylinder{10, 5, 0, false, fn(4)})), 5U);
    EXPECT_EQ(surfaces(*make_solid(Cylinder{1, 1, 1, false, {}})), 3U) << "five by default";
}

TEST(SmoothGroups, BendsAreThoseOfFacets) {
    const auto cylinder = make_solid(Cylinder{10, 5, 5, false, fn(48)});
    float most = 0;
    for (const FacetGroup& group : cylinder->groups) {
        most = std::max(most, group.bend());
    }
    EXPECT_EQ(most, 7.5F);
    EXPECT_EQ(cylinder->groups[0].bend(), 0) << "a cap";
}

TEST(SmoothGroups, OfExtrusions) {
    EXPECT_EQ(surfaces(*extruded(make_outline(Square{}))), 6U);
    for (const double n : {8, 12, 48, 100}) {
        EXPECT_EQ(surfaces(*extruded(circle(5, n))), 3U);
    }
    EXPECT_EQ(surfaces(*extruded(circle(5, 6))), 8U);
    EXPECT_EQ(surfaces(*extruded(make_outline(Square{{10, 10}, true}), 90, 20)), 6U);
    EXPECT_EQ(upright_creases(*extruded(make_outline(Square{{10, 10}, true}), 90, 20)), 80U);
    EXPECT_EQ(surfaces(*extruded(circle(5, 30), 90, 20)), 3U);
}

TEST(SmoothGroups, RoundedCornersGoOnInWalls) {
    Offset round;
    round.corner = Offset::Corner::Round;
    round.distance = 2;
    for (const double n : {12, 48}) {
        round.fineness = fn(n);
        EXPECT_EQ(surfaces(*extruded(offset(make_outline(Square{{10, 20}, true}), round))), 3U) << n;
    }
}

TEST(SmoothGroups, ADropHasOneCorner) {
    Loop drop;
    for (int i = 0; i <= 20; ++i) {
        const double angle = -225 + 270.0 * i / 20;
        drop.emplace_back(5 * cos_degrees(angle), 5 * sin_degrees(angle));
    }
    drop.emplace_back(0, 5 * std::sqrt(2));
    EXPECT_EQ(upright_creases(*extruded(loop_of(drop))), 1U);
}

TEST(SmoothGroups, ChamfersAreCorners) {
    const double rise = 2 * std::tan(glm::radians(5.0));
    // Between two faces that meet at 10 degrees, one of 5 to each.
    const Loop gentle{{0, 0},   {20, 0},         {20, 10},
                      {12, 10}, {10, 10 - rise}, {0, 10 - rise - 10 * std::tan(glm::radians(10.0))}};
    EXPECT_EQ(upright_creases(*extruded(loop_of(gentle))), 6U);
    const Loop eight{{1, 0}, {9, 0}, {10, 1}, {10, 9}, {9, 10}, {1, 10}, {0, 9}, {0, 1}};
    EXPECT_EQ(upright_creases(*extruded(loop_of(eight))), 8U);
}

TEST(SmoothGroups, OfSolidsOfRevolution) {
    RotateExtrude how;
    how.fineness = fn(36);
    Outline ring = circle(2, 24);
    for (glm::dvec2& p : ring.loops[0]) {
        p.x += 10;
    }
    EXPECT_EQ(surfaces(*rotate_extrude(ring, how)), 1U);
    EXPECT_EQ(surfaces(*rotate_extrude(loop_of({{5, 0}, {10, 0}, {10, 3}, {5, 3}}), how)), 4U);
    how.angle = 90;
    EXPECT_EQ(surfaces(*rotate_extrude(ring, how)), 3U);
    how.angle = 360;
    how.fineness = fn(4);
    EXPECT_EQ(surfaces(*rotate_extrude(loop_of({{5, 0}, {10, 0}, {10, 3}, {5, 3}}), how)), 16U);
}

TEST(SmoothGroups, AreEstimated) {
    EXPECT_EQ(surfaces(estimated(Cube{})), 6U);
    for (const double n : {8, 12, 48, 100}) {
        EXPECT_EQ(surfaces(estimated(Cylinder{10, 5, 5, false, fn(n)})), 3U) << n;
        EXPECT_EQ(surfaces(estimated(Sphere{5, fn(n)})), 1U) << n;
        EXPECT_EQ(surfaces(estimated(Cylinder{10, 5, 2, false, fn(n)})), 3U) << n;
    }
    EXPECT_EQ(surfaces(estimated(Cylinder{10, 5, 5, false, fn(6)})), 8U);
    // A chamfered box is no cylinder.
    const Loop eight{{1, 0}, {9, 0}, {10, 1}, {10, 9}, {9, 10}, {1, 10}, {0, 9}, {0, 1}};
    EXPECT_EQ(surfaces(estimated(*extruded(loop_of(eight)))), 10U);
    EXPECT_EQ(surfaces(estimated(*extruded(circle(5, 30), 90, 20))), 3U);
    EXPECT_EQ(surfaces(estimated(*extruded(make_outline(Square{{10, 10}, true}), 45, 40))), 6U);
}

}  // namespace
