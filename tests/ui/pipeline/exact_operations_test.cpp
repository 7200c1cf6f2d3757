// Models that need exact meshes, by way of the interface that csg/solid asks through.
#include "ui/pipeline/mesh/exact_operations.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/csg/solid/mesh_volume.h"

namespace {

using namespace csg::solid;

Mesh box(const glm::dvec3& lo, const glm::dvec3& hi) {
    Mesh mesh;
    for (unsigned i = 0; i < 8; ++i) {
        mesh.points.emplace_back((i & 1) ? hi.x : lo.x, (i & 2) ? hi.y : lo.y, (i & 4) ? hi.z : lo.z);
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

double volume(const MeshResult& result) {
    EXPECT_EQ(result.problem, "");
    return test::mesh_volume(result.mesh.points, result.mesh.triangles);
}

TEST(ExactOperations, Booleans) {
    const auto operations = ui::exact_operations();
    const std::array operands{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
    EXPECT_NEAR(volume(operations->boolean(BooleanKind::Union, operands, {})), 15, 1e-9);
    EXPECT_NEAR(volume(operations->boolean(BooleanKind::Difference, operands, {})), 7, 1e-9);
    EXPECT_NEAR(volume(operations->boolean(BooleanKind::Intersection, operands, {})), 1, 1e-9);
}

TEST(ExactOperations, HullAndMinkowski) {
    const auto operations = ui::exact_operations();
    const std::array<glm::dvec3, 5> points{{{0, 0, 0}, {6, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}}};
    EXPECT_NEAR(volume(operations->hull(points, {})), 1, 1e-9);
    const std::array sums{std::vector{box({0, 0, 0}, {1, 1, 1})}, std::vector{box({0, 0, 0}, {2, 3, 4})}};
    EXPECT_NEAR(volume(operations->minkowski(sums, {})), 60, 1e-9);
}

TEST(ExactOperations, Roofs) {
    const auto operations = ui::exact_operations();
    const Outline square{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}};
    EXPECT_NEAR(volume(operations->roof(square, {}, {})), 4.0 * 4 * 2 / 3, 1e-9);  // A pyramid 2 high.
    // A square ring 1 wide: a ridge 0.5 high all around.
    const Outline ring{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}}};
    EXPECT_NEAR(volume(operations->roof(ring, {.method = "straight", .fineness = {}}, {})), 3, 1e-9);
    // By distance it is higher, as the hole's corners are farther away than its edges' lines.
    EXPECT_GT(volume(operations->roof(ring, {.method = "voronoi", .fineness = {}}, {})), 3.05);
}

}  // namespace
