#include "csg/solid/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "csg/solid/triangulate.h"
#include "csg/solid/triangulate_region.h"

namespace {

using namespace csg::solid;

TEST(Outline, PointsThatWereThereComeBackWithAllTheirBits) {
    const Loop square{{0.1, 0.1}, {1.0 / 3, 0.1}, {1.0 / 3, 0.7}, {0.1, 0.7}};
    const Outline same = clean(std::vector<Loop>{square, {{5, 5}, {6, 5}, {6, 6}}}, FillRule::NonZero);
    for (const glm::dvec2& p : square) {
        bool found = false;
        for (const Loop& loop : same.loops) {
            found = found || std::find(loop.begin(), loop.end(), p) != loop.end();
        }
        EXPECT_TRUE(found) << p.x << ", " << p.y;
    }
}

TEST(Outline, SquaresThatTouchAreOne) {
    const auto square = [](double x) {
        return std::make_shared<Outline>(Outline{{{{x, 0}, {x + 0.1, 0}, {x + 0.1, 1}, {x, 1}}}});
    };
    std::vector<std::shared_ptr<const Outline>> row;
    double x = 0;
    for (int i = 0; i < 10; ++i, x += 0.1) {
        row.push_back(square(x));
    }
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
                if ((a.y < y) != (b.y < y)) {
                    crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
                }
            }
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
            inside += static_cast<int>(std::floor(crossings[k + 1] / side * kSteps + 0.5) -
                                       std::floor(crossings[k] / side * kSteps + 0.5));
        }
    }
    return inside * side * side / (kSteps * kSteps);
}

TEST(Outline, LoopsThatTouchLieTheRightWayRound) {
    // Easily taken for a hole that is none.
    const std::vector<Loop> tangled{
        {{0, 2}, {0, 5}, {1, 4}, {3, 3}}, {{4, 6}, {1, 1}, {3, 3}, {0, 2}}, {{4, 5}, {1, 3}, {1, 1}, {2, 2}}};
    EXPECT_NEAR(clean(tangled, FillRule::EvenOdd).area(), even_odd_area(tangled, 7), 0.03);
    std::mt19937 random(5);
    int off = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<Loop> loops(3);
        for (Loop& loop : loops) {
            for (int i = 0; i < 4 + round % 4; ++i) {
                loop.emplace_back(random() % 7, random() % 7);
            }
        }
        off += std::abs(clean(loops, FillRule::EvenOdd).area() - even_odd_area(loops, 7)) > 0.05 ? 1 : 0;
    }
    EXPECT_EQ(off, 0);
}

/// Where a hole touches the outside, or holes touch each other, each is a loop of its own; regions that touch are
/// apart.
TEST(Outline, LoopsThatMeetInAPointAreSimple) {
    const auto square = [](double x, double y, double size) {
        return Loop{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
    };
    const Outline holes =
        clean(std::vector<Loop>{square(0, 0, 6), square(1, 1, 2), square(3, 3, 2)}, FillRule::EvenOdd);
    EXPECT_EQ(holes.loops.size(), 3u);
    EXPECT_TRUE(is_region(holes));
    const Outline two = clean(std::vector<Loop>{square(0, 0, 1), square(1, 1, 1)}, FillRule::NonZero);
    EXPECT_EQ(two.loops.size(), 2u);
    EXPECT_TRUE(is_region(two));
    const Outline bow = clean(std::vector<Loop>{{{0, 0}, {10, 10}, {10, 0}, {0, 9}}}, FillRule::EvenOdd);
    EXPECT_EQ(bow.loops.size(), 2u);
    EXPECT_TRUE(is_region(bow));
    const Outline tooth = clean(std::vector<Loop>{square(0, 0, 4), {{0, 2}, {2, 1}, {2, 3}}}, FillRule::EvenOdd);
    EXPECT_EQ(tooth.loops.size(), 2u);
    EXPECT_TRUE(is_region(tooth));
    EXPECT_EQ(tooth.area(), 14);
}

TEST(Outline, TheRuleIsChecked) {
    const Loop square{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, turned{{0, 0}, {0, 2}, {2, 2}, {2, 0}};
    EXPECT_TRUE(is_region({{square}}));
    EXPECT_FALSE(is_region({{turned}}));
    EXPECT_FALSE(is_region({{square, square}}));
    EXPECT_FALSE(is_region({{square, {{0.5, 0.5}, {1, 0.5}, {1, 1}}}}));  // A hole the wrong way round.
    EXPECT_TRUE(is_region({{square, {{0.5, 0.5}, {1, 1}, {1, 0.5}}}}));
    EXPECT_FALSE(is_region({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}}));
    EXPECT_FALSE(is_region({{square, {{2, 1}, {3, 1}, {3, 2}}}}));  // Touches where the square has no corner.
    EXPECT_FALSE(is_region({{{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}}}));
}

/// Points next to edges, far closer than the grid is wide.
TEST(Outline, NoPointIsMovedOverAnEdge) {
    std::mt19937 random(3);
    const auto noise = [&] { return (static_cast<double>(random() % 2001) - 1000) * 1e-15; };
    for (int round = 0; round < 300; ++round) {
        std::vector<Loop> loops(1 + round % 3);
        for (Loop& loop : loops) {
            for (int i = 0; i < 12; ++i) {
                const double t = static_cast<double>(random() % 8) / 7;
                loop.emplace_back(t + noise(), t / 3 + static_cast<double>(random() % 2) + noise());
            }
        }
        const Outline outline = clean(loops, FillRule::EvenOdd);
        EXPECT_TRUE(is_region(outline)) << round;
        glm::dmat4 matrix(1.0);
        matrix[0][1] = 0.1 * round;
        matrix[1][0] = -0.3;
        matrix[3][0] = std::ldexp(1.0, round % 50);
        EXPECT_TRUE(is_region(transform(outline, matrix))) << round;
    }
}

/// Two edges that cross become neighbors where what lies between them ends, after all others have begun.
TEST(Outline, EdgesThatCrossAreFoundAfterTheLastOneHasBegun) {
    std::vector<Loop> loops{
        {{-0.2, 1.4}, {1, 1.5}, {-0.1, 1.6}}, {{0, 0}, {0.01, -0.5}, {10, 3}}, {{0.1, 3}, {10, 0}, {0.11, 3.5}}};
    for (int i = 0; i < 30; ++i) {
        loops.push_back({{-2.0 - i, 0}, {-1.5 - i, 0}, {-2.0 - i, 1}});
    }
    double sum = 0;
    for (const Loop& loop : loops) {
        sum += area2(loop) / 2;
    }
    const Outline all = clean(loops, FillRule::NonZero), once = clean(loops, FillRule::EvenOdd);
    EXPECT_TRUE(is_region(all));
    EXPECT_NEAR(2 * all.area() - once.area(), sum, 1e-9);
}

bool is_around(const Outline& outline, const glm::dvec2& p) {
    bool inside = false;
    for (const Loop& loop : outline.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
            if ((a.y > p.y) != (b.y > p.y) && (turn(a, b, p) > 0) == (b.y > a.y)) {
                inside = !inside;
            }
        }
    }
    return inside;
}

csg::Offset rounded(double distance) {
    csg::Offset how;
    how.distance = distance;
    how.fineness.fn = 64;
    return how;
}

/// Turned squares that meet in a corner: the second one has it twice, a rounding apart.
TEST(Offset, LoopsThatTouchAreWidenedAlike) {
    const std::vector<Loop> squares{{{-0.88933523458405928, -7.156052182630261},
                                     {-2.6775526974347441, -8.0517520796693631},
                                     {-3.5732525944738471, -6.2635346168186796},
                                     {-1.7850351316231625, -5.3678347197795757}},
                                    {{-1.3371851831036108, -6.2619434512049184},
                                     {-2.231293914528953, -6.7097933997244699},
                                     {-2.6791438630485045, -5.8156846682991272},
                                     {-1.7850351316231625, -5.3678347197795757}},
                                    {{2.68709969111731, -5.3646523885520541},
                                     {0.89888222826662534, -6.2603522855911571},
                                     {0.003182331227522095, -4.4721348227404727},
                                     {1.7913997940782067, -3.5764349257013692}}};
    const Outline wide = offset(clean(squares, FillRule::EvenOdd), rounded(0.4617290414581952));
    EXPECT_TRUE(is_around(wide, {-1.4732958864031636, -5.110914749767943}));
}

/// However narrow a region is, it is as wide as the distance afterwards; a hole that is as narrow cuts that much.
TEST(Offset, NeedlesAndTheirGaps) {
    constexpr double kPi = 3.14159265358979323846;
    for (double width = 1; width > 1e-15; width /= 7) {
        const Loop needle{{0, 0}, {0.3 * width, -width}, {8, 6}};
        const double grown = offset({{needle}}, rounded(0.5)).area();
        const double length = 10 + 10 + 1.5 * width;
        EXPECT_NEAR(grown, 0.5 * length + kPi * 0.25 + area2(needle) / 2, 0.005 + width) << width;
        EXPECT_TRUE(offset({{needle}}, rounded(-0.5)).empty()) << width;
        const Loop gap(needle.rbegin(), needle.rend());
        const Loop around{{-5, -5}, {15, -5}, {15, 15}, {-5, 15}};
        EXPECT_NEAR(offset({{around, gap}}, rounded(-0.5)).area(), 19 * 19 - grown, 1e-9) << width;
        EXPECT_NEAR(offset({{around, gap}}, rounded(0.5)).area(), 21 * 21 - (4 - kPi) * 0.25, 0.1 * width + 0.01)
            << width;
    }
}

/// What lies on the way of every edge of a comb is swept hundreds of times.
TEST(Offset, TenThousandCorners) {
    Loop star;
    for (int i = 0; i < 10'000; ++i) {
        const double angle = 2 * 3.14159265358979 * i / 10'000, r = i % 2 == 0 ? 9 : 10;
        star.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    EXPECT_NEAR(offset({{star}}, rounded(0.5)).area(), 3.14159265358979 * 10.5 * 10.5, 0.02);
    EXPECT_NEAR(offset({{star}}, rounded(-0.5)).area(), 3.14159265358979 * 8.5 * 8.5, 0.02);
    csg::Offset sharp = rounded(5);
    sharp.corner = csg::Offset::Corner::Miter;  // Each reaches hundreds of units out.
    EXPECT_GT(bounds_of(offset({{star}}, sharp).loops).hi.x, 500);
}

TEST(Outline, TenThousandsOfCorners) {
    Loop star, walk;
    std::mt19937 random(9);
    glm::dvec2 p(0.0);
    for (int i = 0; i < 100'000; ++i) {
        const double angle = 2 * 3.14159265358979 * i / 100'000, r = i % 2 == 0 ? 5 : 10;
        star.emplace_back(r * std::cos(angle), r * std::sin(angle));
        p += glm::dvec2(static_cast<double>(random() % 1000) - 499.5, static_cast<double>(random() % 1000) - 499.5);
        walk.push_back(p);
    }
    const Outline one = clean(std::vector<Loop>{star}, FillRule::EvenOdd);
    EXPECT_EQ(one.corners(), star.size());
    EXPECT_EQ(triangulate_region(index_corners(one)).size(), star.size() - 2);
    const Outline crossing = clean(std::vector<Loop>{walk}, FillRule::EvenOdd);
    EXPECT_TRUE(is_region(crossing));
    EXPECT_GT(crossing.corners(), walk.size());
    // What crosses itself everywhere is refused before it takes hours.
    for (glm::dvec2& corner : walk) {
        corner = {static_cast<double>(random()), static_cast<double>(random())};
    }
    EXPECT_THROW(static_cast<void>(clean(std::vector<Loop>{walk}, FillRule::EvenOdd)), OutlineError);
}

/// A face of a polyhedron with as many corners, simple or not: in far less than the square of that.
TEST(Triangulation, FacesOfManyCorners) {
    std::mt19937 random(9);
    for (const bool crosses : {false, true}) {
        std::vector<glm::dvec3> points;
        std::vector<std::uint32_t> face;
        for (std::uint32_t i = 0; i < 100'000; ++i) {
            const double angle = 2 * 3.14159265358979 * i / 100'000;
            const double r = crosses ? static_cast<double>(random() % 1000) : i % 2 == 0 ? 5 : 10;
            points.emplace_back(r * std::cos(crosses ? 77 * angle : angle), r * std::sin(angle), 0.1 * r);
            face.push_back(i);
        }
        std::vector<glm::uvec3> triangles;
        triangulate(points, face, triangles);
        EXPECT_EQ(triangles.size(), face.size() - 2);
    }
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
        const auto star = [&](glm::dvec2 center, double size, int corners) {
            Loop loop;
            for (int i = 0; i < corners; ++i) {
                const double angle = 2 * 3.14159265358979 * i / corners, r = size * radius(random);
                loop.push_back(center + r * glm::dvec2(std::cos(angle), std::sin(angle)));
            }
            return loop;
        };
        std::vector<std::shared_ptr<const Outline>> operands{
            std::make_shared<Outline>(Outline{{star({0, 0}, 10, 9 + round % 90)}})};
        for (int h = 0; h < round % 12; ++h) {
            operands.push_back(std::make_shared<Outline>(
                Outline{{star({5 * radius(random) * std::cos(h), 5 * radius(random) * std::sin(h)}, 1.2, 3 + h)}}));
        }
        const Outline region = combine(BooleanKind::Difference, operands);
        std::vector<glm::dvec2> points;
        for (const Loop& loop : region.loops) {
            points.insert(points.end(), loop.begin(), loop.end());
        }
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
