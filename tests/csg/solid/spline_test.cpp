#include "csg/solid/spline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "csg/solid/import_outline.h"

namespace {

using namespace csg::solid;

/// A quarter of a circle as a rational curve of degree 2.
Spline quarter() {
    return {2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, std::sqrt(0.5), 1}};
}

TEST(Splines, RationalOnesAreCircles) {
    const auto points = points_along(quarter(), 10);
    ASSERT_TRUE(points);
    ASSERT_EQ(points->size(), 11u);
    for (const glm::dvec2& p : *points) {
        EXPECT_NEAR(glm::length(p), 1, 1e-12);
    }
    EXPECT_NEAR(points->front().x, 1, 1e-12);
    EXPECT_NEAR(points->back().y, 1, 1e-12);
}

/// The blossom of a cubic: with knots 0, 1, 2, … its points on a line are the line.
TEST(Splines, OfPointsOnALineAreTheLine) {
    Spline line{3, {}, {}, {}};
    for (int i = 0; i < 8; ++i) {
        line.points.emplace_back(i, 2 * i);
    }
    for (int i = 0; i < 12; ++i) {
        line.knots.push_back(i);
    }
    const auto points = points_along(line, 3);
    ASSERT_TRUE(points);
    EXPECT_EQ(points->size(), 5u * 3 + 1);
    for (const glm::dvec2& p : *points) {
        EXPECT_NEAR(p.y, 2 * p.x, 1e-12);
    }
    EXPECT_NEAR(points->front().x, 1, 1e-12);
    EXPECT_NEAR(points->back().x, 6, 1e-12);
}

TEST(Splines, NumbersThatDoNotFitGiveNothing) {
    Spline s = quarter();
    s.knots.pop_back();
    EXPECT_FALSE(points_along(s, 4));
    s = quarter();
    s.weights[1] = 0;
    EXPECT_FALSE(points_along(s, 4));
    s = quarter();
    s.degree = 1'000'000;
    EXPECT_FALSE(points_along(s, 4));
    s = quarter();
    s.knots[2] = 5;
    EXPECT_FALSE(points_along(s, 4));
}

TEST(Import, DxfSplinesAndRowsOfBlocks) {
    const auto area = [](const std::string& text, Remarks& remarks) {
        return clean(read_dxf(text, {}, remarks), FillRule::EvenOdd).area();
    };
    Remarks remarks;
    // Half of a disc of radius 10, closed straight.
    const std::string spline =
        "0\nSPLINE\n70\n0\n71\n2\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n2\n40\n2\n40\n2\n"
        "41\n1\n41\n0.70710678\n41\n1\n41\n0.70710678\n41\n1\n"
        "10\n10\n20\n0\n10\n10\n20\n10\n10\n0\n20\n10\n10\n-10\n20\n10\n10\n-10\n20\n0\n";
    const auto entities = [](const std::string& body) { return "0\nSECTION\n2\nENTITIES\n" + body + "0\nENDSEC\n"; };
    EXPECT_NEAR(area(entities(spline), remarks), 157.08, 3);
    EXPECT_TRUE(remarks.warnings.empty() && remarks.failures.empty());
    EXPECT_EQ(area(entities("0\nSPLINE\n71\n3\n40\n1\n10\n0\n20\n0\n"), remarks), 0);
    EXPECT_EQ(remarks.failures.size(), 1u);
    remarks = {};
    const std::string square = "0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n10\n0\n20\n1\n";
    EXPECT_NEAR(area("0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n" + square + "0\nENDBLK\n0\nENDSEC\n" +
                         entities("0\nINSERT\n2\na\n70\n4\n71\n3\n44\n2\n45\n5\n50\n30\n"),
                     remarks),
                12, 1e-6);
    EXPECT_TRUE(remarks.warnings.empty() && remarks.failures.empty());
}

}  // namespace
