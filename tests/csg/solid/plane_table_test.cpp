#include "csg/solid/plane_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using csg::solid::coincidence_tolerance;
using csg::solid::PlaneRef;
using csg::solid::PlaneTable;
using glm::dvec3;

struct Triangle {
    dvec3 a, b, c;
};
PlaneRef add(PlaneTable& table, const Triangle& t) {
    return table.add(t.a, t.b, t.c);
}
Triangle reversed(const Triangle& t) {
    return {t.a, t.c, t.b};
}

/// Random triangles on the plane through `origin` spanned by u and v.
Triangle on_plane(std::mt19937_64& random, const dvec3& origin, const dvec3& u, const dvec3& v) {
    std::uniform_real_distribution<double> at(-1, 1);
    const auto point = [&] { return origin + at(random) * u + at(random) * v; };
    Triangle t{point(), point(), point()};
    return glm::dot(glm::cross(t.b - t.a, t.c - t.a), glm::cross(u, v)) < 0 ? reversed(t) : t;
}

TEST(PlaneTable, CoincidentAndOppositeFacesShareAnEntryAtAnyScale) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    const auto direction = [&] { return glm::normalize(dvec3(normal(random), normal(random), normal(random))); };
    for (const double scale : {1e-6, 1.0, 1e6}) {
        PlaneTable table(coincidence_tolerance(4 * scale));
        for (int round = 0; round < 2000; ++round) {
            const dvec3 u = scale * direction(), v = scale * direction(), origin = scale * direction();
            if (glm::length(glm::cross(u, v)) < 0.3 * scale * scale) {
                continue;
            }
            // A wide triangle first, as csg::solid::place adds them.
            const PlaneRef first = add(table, {origin - u - v, origin + u - v, origin + v});
            for (int i = 0; i < 5; ++i) {
                const Triangle t = on_plane(random, origin, u, v);
                if (glm::length(glm::cross(t.b - t.a, t.c - t.a)) < 0.02 * scale * scale) {
                    continue;
                }
                const PlaneRef same = add(table, t), opposite = add(table, reversed(t));
                ASSERT_EQ(same.index, first.index) << scale << ", round " << round;
                ASSERT_EQ(same.flipped, first.flipped);
                ASSERT_EQ(opposite.index, first.index);
                ASSERT_NE(opposite.flipped, first.flipped);
            }
        }
    }
}

TEST(PlaneTable, NearlyEqualPlanesAreTwo) {
    const Triangle t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto moved = [&](double dz) {
        return Triangle{t.a + dvec3(0, 0, dz), t.b + dvec3(0, 0, dz), t.c + dvec3(0, 0, dz)};
    };
    for (const double size : {1e-6, 1.0, 1e6}) {
        PlaneTable table(coincidence_tolerance(size));
        const auto scaled = [&](const Triangle& x) { return Triangle{size * x.a, size * x.b, size * x.c}; };
        const auto index = [&](const Triangle& x) { return add(table, scaled(x)).index; };
        EXPECT_EQ(index(t), 0U);
        EXPECT_EQ(index(moved(1e-12)), 0U);
        EXPECT_EQ(index(moved(1e-8)), 1U);
        EXPECT_EQ(index(moved(-1e-8)), 2U);
        EXPECT_EQ(index({t.a, t.b, {0, 1, 1e-8}}), 3U);  // turned
        EXPECT_EQ(index(t), 0U);
    }
}

/// Neighboring cells of the hash hold coincident planes too: offsets and normals on their borders.
TEST(PlaneTable, BordersOfCellsDoNotMatter) {
    PlaneTable table(coincidence_tolerance(1.0));
    const double tolerance = table.tolerance();
    for (int i = 1; i < 2000; ++i) {
        const double z = i * 1e-4;  // on the border of a cell of offsets
        const auto at = [&](double dz) { return table.add({0, 0, z + dz}, {1, 0, z + dz}, {0, 1, z + dz}).index; };
        const std::uint32_t first = at(0);
        EXPECT_EQ(at(0.5 * tolerance), first);
        EXPECT_EQ(at(-0.5 * tolerance), first);
    }
    for (int i = 1; i < 900; ++i) {
        const double s = i * 1e-3, c = std::sqrt(1 - s * s);
        const auto at = [&](double turn) {
            const dvec3 u(c - turn * s, 0, -(s + turn * c));
            return table.add({0, 0, 0}, u, {0, 1, 0}).index;
        };
        const std::uint32_t first = at(0);
        EXPECT_EQ(at(0.5 * tolerance), first);
        EXPECT_EQ(at(-0.5 * tolerance), first);
    }
}

TEST(PlaneTable, SameOrderSameTable) {
    const auto fill = [] {
        std::mt19937_64 random(3);
        PlaneTable table(coincidence_tolerance(3));
        std::vector<std::uint32_t> indices;
        for (int i = 0; i < 3000; ++i) {
            const auto point = [&] {
                return dvec3(static_cast<double>(random() % 4), static_cast<double>(random() % 4),
                             static_cast<double>(random() % 4));
            };
            const dvec3 a = point(), b = point(), c = point();
            indices.push_back(table.add(a, b, c).index);
        }
        return indices;
    };
    EXPECT_EQ(fill(), fill());
}

TEST(PlaneTable, TrianglesWithoutAreaGetAFinitePlaneThroughThem) {
    PlaneTable table(coincidence_tolerance(2));
    for (const Triangle& t : {Triangle{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, Triangle{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}},
                              Triangle{{1, 2, 0}, {1, 2, 1}, {1, 2, 0}}}) {
        const csg::solid::Plane& plane = table.planes()[add(table, t).index];
        EXPECT_NEAR(glm::length(plane.normal), 1, 1e-12);
        for (const dvec3& p : {t.a, t.b, t.c}) {
            EXPECT_NEAR(glm::dot(plane.normal, p), plane.offset, 1e-12);
        }
    }
}

}  // namespace
