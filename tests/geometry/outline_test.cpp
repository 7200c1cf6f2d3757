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
        for (const glm::uvec3& t : triangulate_region(region)) {
            const double a = area2({points[t.x], points[t.y], points[t.z]}) / 2;
            sum += a;
            absolute += std::abs(a);
        }
        EXPECT_NEAR(sum, region.area(), 1e-9 * absolute) << round;
        EXPECT_NEAR(absolute, region.area(), 1e-9 * absolute) << round;
    }
}

}  // namespace
