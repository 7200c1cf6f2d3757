// Corners that linear_extrude() adds on edges.
#include "csg/solid/segments.h"
#include "csg/solid/slices.h"

#include <gtest/gtest.h>

namespace {

using namespace csg::solid;

std::size_t corners(const csg::LinearExtrude& how, const Loop& loop) {
    const Outline divided = divide_edges({{loop}}, how, 10);
    EXPECT_NEAR(area2(divided.loops[0]), area2(loop), 1e-12) << "corners lie on edges";
    return divided.loops[0].size();
}

const Loop kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const Loop kBar{{0, 0}, {8, 0}, {8, 2}, {0, 2}};

TEST(DividedEdges, AreAsManyAsSegmentsSay) {
    csg::LinearExtrude how;
    EXPECT_EQ(corners(how, kSquare), 4u) << "walls are plane";
    how.segments = 12;
    EXPECT_EQ(corners(how, kSquare), 12u);
    how.segments = 11;
    EXPECT_EQ(corners(how, kSquare), 8u) << "edges of one length are divided alike";
    how.segments = 10;
    EXPECT_EQ(corners(how, kBar), 10u) << "long edges first: 4 pieces each, of length 2";
    how.segments = 3;
    EXPECT_EQ(corners(how, kSquare), 4u);
    how.segments = 0;
    how.twist = 90;
    EXPECT_EQ(corners(how, kSquare), 4u) << "0 divides none";
}

TEST(DividedEdges, FollowFinenessWhereWallsAreBent) {
    csg::LinearExtrude how;
    how.twist = 90;
    how.fineness.fn = 16;
    EXPECT_EQ(corners(how, kSquare), 16u);
    how.fineness = {};
    how.fineness.fs = 1;
    EXPECT_EQ(corners(how, kSquare), 8u) << "no longer than $fs";
    how.fineness.fs = 0.01;
    how.fineness.fa = 30;
    EXPECT_EQ(corners(how, kSquare), 12u) << "no more than $fa asks for";
    how = {};
    how.scale = {1, 3};
    how.fineness.fs = 1;
    EXPECT_EQ(corners(how, kSquare), 16u) << "at the top, where upright edges are three times as long";
}

TEST(Slices, ByErrorStayAsNearToTheHelix) {
    csg::LinearExtrude how;
    how.twist = -90;
    how.fineness.fe = 0.1;
    // The corner at 10·√2 is off by 10·√2·(1 − cos(a / 2)) half way along an edge of angle a.
    EXPECT_EQ(slice_count({{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}}, how), 7u);
    EXPECT_EQ(slice_count({{{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}}}, how), 5u);
    how.fineness.fe = 1000;
    EXPECT_EQ(slice_count({{kSquare}}, how), 1u);
}

}  // namespace
