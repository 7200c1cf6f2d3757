// Normals of smooth surfaces at the corners of their triangles.
#include "csg/solid/corner_normals.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace csg;
using namespace csg::solid;

PlacedLeaf placed(const LeafShape& shape) {
    PlacedLeaf leaf;
    leaf.solid = make_solid(shape);
    leaf.points = leaf.solid->points;
    leaf.triangles = leaf.solid->triangles;
    return leaf;
}

Fineness fn(double segments) {
    Fineness fine;
    fine.fn = segments;
    return fine;
}

TEST(CornerNormals, OfACylinderPointAwayFromItsAxis) {
    const PlacedLeaf leaf = placed(Cylinder{20, 10, 10, false, fn(64)});
    const std::vector<CornerNormals> normals = corner_normals(leaf);
    ASSERT_EQ(normals.size(), leaf.triangles.size());
    int walls = 0;
    for (std::size_t t = 0; t < normals.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3& n = normals[t][static_cast<std::size_t>(i)];
            if (n == glm::dvec3(0)) {
                continue;  // A cap.
            }
            const glm::dvec3& p = leaf.points[leaf.triangles[t][i]];
            EXPECT_LT(glm::distance(n, glm::dvec3(p.x, p.y, 0) / 10.0), 1e-12);
            ++walls;
        }
    }
    EXPECT_EQ(walls, 3 * 2 * 64);
}

TEST(CornerNormals, OfASphereAreNearlyItsOwn) {
    const PlacedLeaf leaf = placed(Sphere{10, fn(64)});
    const std::vector<CornerNormals> normals = corner_normals(leaf);
    double worst = 0;
    for (std::size_t t = 0; t < normals.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            worst = std::max(worst, glm::distance(normals[t][static_cast<std::size_t>(i)],
                                                  glm::normalize(leaf.points[leaf.triangles[t][i]])));
        }
    }
    EXPECT_LT(worst, 0.03);
}

TEST(CornerNormals, ThereIsNoneAtTheTipOfACone) {
    const PlacedLeaf leaf = placed(Cylinder{20, 10, 0, false, fn(32)});
    const std::vector<CornerNormals> normals = corner_normals(leaf);
    int tips = 0;
    for (std::size_t t = 0; t < normals.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3& p = leaf.points[leaf.triangles[t][i]];
            const glm::dvec3& n = normals[t][static_cast<std::size_t>(i)];
            if (p.z > 19) {
                ++tips;
                EXPECT_EQ(n, glm::dvec3(0));
            } else if (n != glm::dvec3(0)) {
                EXPECT_NEAR(n.z, 10 / std::hypot(10, 20), 0.01);
            }
        }
    }
    EXPECT_EQ(tips, 32);
}

TEST(CornerNormals, OfFlatFacesThereIsNone) {
    EXPECT_TRUE(corner_normals(placed(Cube{glm::dvec3(4), true})).empty());
    EXPECT_TRUE(corner_normals(placed(Cylinder{4, 4, 4, false, fn(6)})).empty()) << "asked for corners";
}

}  // namespace
