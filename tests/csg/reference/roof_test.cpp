// Roofs against closed forms and against the distance to the outline.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "csg/reference/grid_outline.h"
#include "csg/reference/roof.h"
#include "csg/reference/self_intersection.h"
#include "csg/reference/voronoi_roof.h"
#include "csg/solid/outline.h"

namespace {

using csg::Fineness;
using csg::reference::Mesh;
using csg::reference::roof;
using csg::reference::voronoi_roof;
using csg::solid::Loop;
using Loops = std::vector<Loop>;

constexpr Fineness kFine{256, 12, 2};

Loops square(double a, const glm::dvec2& at = {0, 0}) {
    return {{at, at + glm::dvec2(a, 0), at + glm::dvec2(a, a), at + glm::dvec2(0, a)}};
}

const Loops kL{{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}};
const Loops kPlus{
    {{-3, -1}, {-1, -1}, {-1, -3}, {1, -3}, {1, -1}, {3, -1}, {3, 1}, {1, 1}, {1, 3}, {-1, 3}, {-1, 1}, {-3, 1}}};
const Loops kHoles{{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}},
                   {{-2, -2}, {-2.5, -1}, {-1, -0.5}, {-0.5, -2.25}},
                   {{1, 1}, {1, 2.5}, {3, 2}, {1.5, 1.75}}};

/// Checks what every roof must be: closed, outward, at and above z = 0, without crossing itself.
double volume(const Mesh& mesh) {
    const auto facts = csg::reference::facts(mesh);
    EXPECT_TRUE(facts.manifold);
    EXPECT_GT(facts.volume, 0);
    EXPECT_EQ(facts.box.lo.z, 0);
    EXPECT_EQ(csg::reference::count_self_intersections(mesh, 1e-6), 0u);
    return facts.volume;
}

double volume(const Loops& loops, const Fineness& fineness = kFine) {
    return volume(voronoi_roof(loops, fineness));
}

bool is_inside(const Loops& loops, const glm::dvec2& p) {
    bool inside = false;
    for (const Loop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
                inside = !inside;
            }
        }
    }
    return inside;
}

double distance(const Loops& loops, const glm::dvec2& p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Loop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 a = loop[i], way = loop[(i + 1) % loop.size()] - a;
            const double t = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
            nearest = std::min(nearest, glm::distance(p, a + t * way));
        }
    }
    return nearest;
}

/// The integral of the distance over the region, by the middles of small squares.
double integral(const Loops& loops) {
    constexpr int kSteps = 800;
    const csg::Box box = csg::solid::bounds_of(loops);
    const glm::dvec2 step = glm::dvec2(box.size()) / double{kSteps};
    double sum = 0;
    for (int y = 0; y < kSteps; ++y) {
        for (int x = 0; x < kSteps; ++x) {
            const glm::dvec2 p = glm::dvec2(box.lo) + step * glm::dvec2(x + 0.5, y + 0.5);
            if (is_inside(loops, p)) {
                sum += distance(loops, p);
            }
        }
    }
    return sum * step.x * step.y;
}

TEST(VoronoiRoof, OfConvexOutlinesIsTheStraightSkeletons) {
    EXPECT_NEAR(volume(square(4)), 64.0 / 6, 1e-12);
    EXPECT_NEAR(volume(square(0.3, {1e5, -7})), 0.027 / 6, 1e-9);
    const Loops convex{{{0, 0}, {5, 1}, {6, 3}, {3, 6}, {-1, 2}}};
    EXPECT_NEAR(volume(convex), volume(roof(convex)), 1e-7);
    EXPECT_NEAR(volume(convex, {3, 12, 2}), volume(roof(convex)), 1e-7);
}

TEST(VoronoiRoof, OfAnLHasAConeAtItsCorner) {
    // The straight skeleton's 16/3, and what a cone of a quarter turn adds between its planes, out to the parabolas.
    EXPECT_NEAR(volume(kL), integral(kL), 1e-3);
    EXPECT_NEAR(volume(roof(kL)), 16.0 / 3, 1e-9);
    EXPECT_GT(volume(kL), 16.0 / 3 + 0.05);
}

TEST(VoronoiRoof, IsAsHighAsTheOutlineIsFar) {
    EXPECT_NEAR(volume(kPlus), integral(kPlus), 1e-3);
    EXPECT_NEAR(volume(kHoles), integral(kHoles), 1e-3);
    const Mesh mesh = voronoi_roof(kHoles, {});
    for (const glm::dvec3& p : mesh.points) {
        EXPECT_NEAR(p.z, distance(kHoles, glm::dvec2(p)), 1e-8);
    }
}

TEST(VoronoiRoof, IsDividedByFineness) {
    const double exact = integral(kL);
    double last = std::numeric_limits<double>::infinity();
    std::size_t triangles = 0;
    for (const double fn : {8.0, 16.0, 64.0}) {
        const Mesh mesh = voronoi_roof(kL, {fn, 12, 2});
        const double off = std::abs(volume(mesh) - exact);
        EXPECT_LT(off, last / 2);
        EXPECT_GT(mesh.triangles.size(), triangles);
        last = off;
        triangles = mesh.triangles.size();
    }
    EXPECT_GT(voronoi_roof(kL, {0, 3, 0.01}).points.size(), voronoi_roof(kL, {0, 12, 2}).points.size());
}

TEST(VoronoiRoof, OfSeveralOutlinesThatTouch) {
    // Corner to corner; the second has its corner on the middle of the first's edge; collinear corners.
    Loops corners = square(2);
    corners.push_back(square(1, {2, 2})[0]);
    EXPECT_NEAR(volume(corners), 9.0 / 6, 1e-12);
    const Loops middle{square(2)[0], {{2, 1}, {4, 0}, {4, 2}}};
    EXPECT_NEAR(volume(middle), integral(middle), 1e-3);
    const Loops hole{square(4)[0], {{4, 2}, {3, 1}, {2, 2}, {3, 3}}};
    EXPECT_NEAR(volume(hole), integral(hole), 1e-3);
    const Loops rectangle{{{0, 0}, {4, 0}, {4, 2}, {0, 2}}};
    EXPECT_NEAR(volume(Loops{square(2)[0], square(2, {2, 0})[0]}), volume(rectangle), 1e-12);
    const Loops collinear{{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1.5}}};
    EXPECT_NEAR(volume(collinear), 8.0 / 6, 1e-12);
}

TEST(VoronoiRoof, KeepsTheOutlinesCorners) {
    const Loops odd{{{0.1, 0.2}, {1.0 / 3, 0.1}, {0.7, 0.9}}};
    const Mesh mesh = voronoi_roof(odd, {});
    for (const glm::dvec2& p : odd[0]) {
        EXPECT_NE(std::find(mesh.points.begin(), mesh.points.end(), glm::dvec3(p, 0)), mesh.points.end());
    }
}

TEST(VoronoiRoof, OfRandomStars) {
    std::mt19937 random(7);
    for (int round = 0; round < 60; ++round) {
        Loops star(1);
        const int n = 5 + round;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n;
            const double r = 1 + static_cast<double>(random() % 1000) / 100;
            star[0].emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
        const double loose = volume(voronoi_roof(star, {24, 12, 2}));
        EXPECT_GT(loose, 0) << round;
    }
}

TEST(VoronoiRoof, OfRandomOutlinesThatTouch) {
    // On a grid of few points, so that corners meet corners and edges often.
    std::mt19937 random(11);
    int refused = 0;
    for (int round = 0; round < 1000; ++round) {
        SCOPED_TRACE(round);
        Loops loops(1 + static_cast<std::size_t>(round % 3));
        for (Loop& loop : loops) {
            for (int i = 0; i < 4 + round % 5; ++i) {
                loop.emplace_back(random() % 7, random() % 7);
            }
        }
        const csg::solid::Outline outline = csg::solid::clean(loops, csg::solid::FillRule::EvenOdd);
        // Rounding makes some loops cross that touched where edges had crossed.
        Mesh mesh;
        try {
            mesh = voronoi_roof(outline.loops, {12, 12, 2});
        } catch (const std::runtime_error&) {
            ++refused;  // A loop that touches itself and lies on both sides of the region.
            continue;
        }
        EXPECT_TRUE(outline.empty() || volume(mesh) > 0) << round;
        // Not counting edges with the region on both sides.
        const csg::reference::GridOutline grid(outline.loops);
        Loops bounds;
        for (const auto& loop : grid.loops()) {
            bounds.emplace_back();
            for (const auto& p : loop) {
                bounds.back().push_back(grid.corner(p));
            }
        }
        double area = 0;
        for (const Loop& loop : bounds) {
            area += csg::solid::area2(loop) / 2;
        }
        EXPECT_NEAR(area, outline.area(), 1e-6) << round;
        for (const glm::dvec3& p : mesh.points) {
            ASSERT_NEAR(p.z, distance(bounds, glm::dvec2(p)), 1e-7) << round;
        }
    }
    EXPECT_LE(refused, 1);
}

TEST(VoronoiRoof, OfDegenerateOutlines) {
    EXPECT_TRUE(voronoi_roof({}, {}).empty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Loop& loop : {Loop{}, Loop{{1, 1}}, Loop{{1, 1}, {1, 1}, {1, 1}}, Loop{{0, 0}, {1, 0}},
                             Loop{{0, 0}, {1, 1}, {2, 2}, {5, 5}}}) {
        EXPECT_TRUE(voronoi_roof(Loops{loop}, {}).empty());
    }
    const Loop crossing{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    EXPECT_THROW((void)voronoi_roof(Loops{crossing}, {}), std::runtime_error);
    EXPECT_THROW((void)voronoi_roof(Loops{square(1)[0], square(1)[0]}, {}), std::runtime_error);
    EXPECT_THROW((void)voronoi_roof(Loops{{{0, 0}, {nan, 0}, {1, 1}}}, {}), std::runtime_error);
    EXPECT_THROW((void)voronoi_roof(Loops{{{0, 0}, {1e308, -1e308}, {-1e308, 1e308}}}, {}), std::runtime_error);
}

}  // namespace
