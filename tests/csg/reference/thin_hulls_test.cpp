// Unions of hulls next to flat, which share planes, edges and corners up to their thickness: as Minkowski sums with a
// disc make them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "csg/reference/hull.h"
#include "csg/reference/mesh_boolean.h"
#include "tests/csg/reference/membership.h"
#include "tests/csg/reference/meshes.h"
#include "tests/csg/reference/random_numbers.h"

namespace {

using csg::reference::BooleanRequest;
using csg::reference::BooleanResult;
using csg::reference::Mesh;
using csg::reference::Method;
using meshes::Random;

using Points = std::vector<glm::dvec3>;

/// A prism of so many corners and next to no height, turned.
Points disc(int corners, double radius, double height, const glm::dmat3& turned) {
    Points points;
    for (int i = 0; i < corners; ++i) {
        const double a = 2 * std::numbers::pi * i / corners;
        for (const double z : {0.0, height}) {
            points.push_back(turned * glm::dvec3(radius * std::cos(a), radius * std::sin(a), z));
        }
    }
    return points;
}

glm::dmat3 turn(int axis, double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    glm::dmat3 m(1.0);
    m[u][u] = m[v][v] = std::cos(a);
    m[u][v] = std::sin(a);
    m[v][u] = -std::sin(a);
    return m;
}

/// Of the sums of the points.
Mesh sum(const Points& a, const Points& b) {
    Points points;
    for (const glm::dvec3& p : a) {
        for (const glm::dvec3& q : b) {
            points.push_back(p + q);
        }
    }
    return csg::reference::hull(points);
}

/// The faces of a ring of so many segments with a profile of so many corners.
std::vector<Points> ring(int segments, int corners, double radius) {
    const auto at = [&](int i, int k) {
        const double a = 2 * std::numbers::pi * (i % segments) / segments;
        const double b = 2 * std::numbers::pi * (k % corners) / corners, r = radius + std::cos(b);
        return glm::dvec3(r * std::cos(a), r * std::sin(a), std::sin(b));
    };
    std::vector<Points> faces;
    for (int i = 0; i < segments; ++i) {
        for (int k = 0; k < corners; ++k) {
            faces.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    }
    return faces;
}

/// The faces of a box with a box taken from its corner: many in common planes.
std::vector<Points> notch(Random& random) {
    const double a = random.whole(1, 2), b = 3;
    return {{{0, 0, 0}, {b, 0, 0}, {b, b, 0}, {0, b, 0}}, {{0, 0, 0}, {b, 0, 0}, {b, 0, b}, {0, 0, b}},
            {{0, 0, 0}, {0, b, 0}, {0, b, b}, {0, 0, b}}, {{a, a, a}, {b, a, a}, {b, b, a}, {a, b, a}},
            {{a, a, a}, {b, a, a}, {b, a, b}, {a, a, b}}, {{a, a, a}, {a, b, a}, {a, b, b}, {a, a, b}},
            {{b, 0, 0}, {b, b, 0}, {b, b, a}, {b, 0, a}}, {{b, 0, a}, {b, a, a}, {b, a, b}, {b, 0, b}}};
}

void expect_union(const std::vector<Mesh>& hulls) {
    const auto [scene, geometry] = csg::reference::make_mesh_scene(csg::ExpressionKind::Union, hulls);
    BooleanRequest exactly;
    exactly.method = Method::Exact;
    BooleanResult exact, found;
    ASSERT_NO_THROW(exact = csg::reference::make_mesh(scene, geometry, exactly));
    ASSERT_NO_THROW(found = csg::reference::make_mesh(scene, geometry));
    EXPECT_TRUE(exact.facts.manifold);
    EXPECT_NEAR(found.facts.volume, exact.facts.volume, 1e-6 * exact.facts.area);
    EXPECT_EQ(meshes::count_wrong_points(scene, geometry, exact.mesh, geometry.box, 20), 0u);
}

TEST(ThinHulls, ARingWithATurnedDisc) {
    const Points turned = disc(3, 1, 1e-7, turn(2, 315) * turn(0, 270));
    std::vector<Mesh> hulls;
    for (const Points& face : ring(9, 3, 2)) {
        hulls.push_back(sum(face, turned));
    }
    expect_union(hulls);
}

int number_of_cases() {
    const char* text = std::getenv("CSGSCOPE_THIN_CASES");
    return text != nullptr ? std::atoi(text) : 4;
}

TEST(ThinHulls, RandomOnes) {
    const int first = std::getenv("CSGSCOPE_THIN_FIRST") != nullptr ? std::atoi(std::getenv("CSGSCOPE_THIN_FIRST")) : 0;
    for (int seed = first; seed < first + number_of_cases(); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const double height = std::pow(10.0, -random.whole(3, 14));
        constexpr double kAngles[] = {0, 30, 45, 90, 180, 270, 315, 17.3};
        const glm::dmat3 turned = turn(2, kAngles[random.whole(0, 7)]) * turn(0, kAngles[random.whole(0, 7)]);
        const Points with = disc(random.whole(3, 6), random.whole(1, 2) * 0.5, height, turned);
        std::vector<Points> faces =
            random.chance(0.5) ? ring(random.whole(3, 9), random.whole(3, 5), random.whole(2, 4)) : notch(random);
        std::vector<Mesh> hulls;
        for (const Points& face : faces) {
            Mesh hull = sum(face, with);
            if (!hull.empty()) {
                hulls.push_back(std::move(hull));
            }
        }
        expect_union(hulls);
    }
}

}  // namespace
