#include "csg/solid/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "csg/solid/triangulate_region.h"

namespace {

using namespace csg::solid;

TEST(Outline, PointsThatWereThereComeBackWithAllTheirBits) {
    const Loop square{{0.1, 0.1}, {1.0 / 3, 0.1}, {1.0 / 3, 0.7}, {0.1, 0.7}};
    const Outline same = clean(std::vector<Loop>{square, {{5, 5}, {6, 5}, {6, 6}}}, FillRule::NonZero);
    for (const glm::dvec2& p : square) {
        bool found = false;
        for (const Loop& loop : same.loops)
            found = found || std::find(loop.begin(), loop.end(), p) != loop.end();
        EXPECT_TRUE(found) << p.x << ", " << p.y;
    }
}

TEST(Outline, SquaresThatTouchAreOne) {
    const auto square = [](double x) {
        return std::make_shared<Outline>(Outline{{{{x, 0}, {x + 0.1, 0}, {x + 0.1, 1}, {x, 1}}}});
    };
    std::vector<std::shared_ptr<const Outline>> row;
    double x = 0;
    for (int i = 0; i < 10; ++i, x += 0.1)
        row.push_back(square(x));
    const Outline all = combine(BooleanKind::Union, row);
    ASSERT_EQ(all.loops.size(), 1u);
    EXPECT_EQ(all.loops[0].size(), 4u);
    EXPECT_NEAR(all.area(), 1, 1e-12);
}

/// Of what an odd number of loops is around, by small squares.
double even_odd_area(const std::vector<Loop>& loops, double side) {
    constexpr int kSteps = 700;
    int inside = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double y = (i + 0.5) * side / kSteps;
        std::vector<double> crossings;
        for (const Loop& loop : loops) {
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const glm::dvec2 &a = loop[k], &b = loop[(k + 1) % loop.size()];
                if ((a.y < y) != (b.y < y))
                    crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
            }
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
            inside += static_cast<int>(std::floor(crossings[k + 1] / side * kSteps + 0.5) -
                                       std::floor(crossings[k] / side * kSteps + 0.5));
    }
    return inside * side * side / (kSteps * kSteps);
}

TEST(Outline, LoopsThatTouchLieTheRightWayRound) {
    // Clipper takes one of these loops for a hole that is none.
    const std::vector<Loop> tangled{
        {{0, 2}, {0, 5}, {1, 4}, {3, 3}}, {{4, 6}, {1, 1}, {3, 3}, {0, 2}}, {{4, 5}, {1, 3}, {1, 1}, {2, 2}}};
    EXPECT_NEAR(clean(tangled, FillRule::EvenOdd).area(), even_odd_area(tangled, 7), 0.03);
    std::mt19937 random(5);
    int off = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<Loop> loops(3);
        for (Loop& loop : loops) {
            for (int i = 0; i < 4 + round % 4; ++i)
                loop.emplace_back(random() % 7, random() % 7);
        }
        off += std::abs(clean(loops, FillRule::EvenOdd).area() - even_odd_area(loops, 7)) > 0.05 ? 1 : 0;
    }
    EXPECT_EQ(off, 0);
}

TEST(Outline, CoordinatesThatAreNotFiniteAreLeftOut) {
    EXPECT_TRUE(clean(std::vector<Loop>{{{0, 0}, {1, 0}, {HUGE_VAL, 1}}}, FillRule::NonZero).empty());
    EXPECT_TRUE(hull(std::vector<glm::dvec2>{{0, 0}, {std::nan(""), 1}, {1, 1}}).empty());
}

/// Random star-shaped rings with random holes: areas of triangles are positive and sum up to the region's.
TEST(Triangulation, FillsRandomRegionsExactly) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> radius(0.5, 1);
    for (int round = 0; round < 300; ++round) {
        const auto star = [&](glm::dvec2 centre, double size, int corners) {
            Loop loop;
            for (int i = 0; i < corners; ++i) {
                const double angle = 2 * 3.14159265358979 * i / corners, r = size * radius(random);
                loop.push_back(centre + r * glm::dvec2(std::cos(angle), std::sin(angle)));
            }
            return loop;
        };
        std::vector<std::shared_ptr<const Outline>> operands{
            std::make_shared<Outline>(Outline{{star({0, 0}, 10, 9 + round % 90)}})};
        for (int h = 0; h < round % 12; ++h)
            operands.push_back(std::make_shared<Outline>(
                Outline{{star({5 * radius(random) * std::cos(h), 5 * radius(random) * std::sin(h)}, 1.2, 3 + h)}}));
        const Outline region = combine(BooleanKind::Difference, operands);
        std::vector<glm::dvec2> points;
        for (const Loop& loop : region.loops)
            points.insert(points.end(), loop.begin(), loop.end());
        double sum = 0, absolute = 0;
        for (const glm::uvec3& t : triangulate_region(index_corners(region))) {
            const double a = area2({points[t.x], points[t.y], points[t.z]}) / 2;
            sum += a;
            absolute += std::abs(a);
        }
        EXPECT_NEAR(sum, region.area(), 1e-9 * absolute) << round;
        EXPECT_NEAR(absolute, region.area(), 1e-9 * absolute) << round;
    }
}

}  // namespace
