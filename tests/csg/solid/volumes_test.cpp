// Models of one line whose volume is known: every leaf of theirs is closed, and together they have it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "csg/solid/placed.h"
#include "tests/csg/scad/evaluate_text.h"
#include "tests/csg/solid/mesh_volume.h"

namespace {

/// Every edge is used as often in one direction as in the other.
bool is_closed(const csg::solid::PlacedLeaf& leaf) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const glm::uvec3& t : leaf.triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
    return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

TEST(Volumes, AreWhatGeometrySays) {
    std::ifstream in(std::string(CSGSCOPE_SOURCE_DIR) + "/tests/csg/solid/volumes.txt");
    std::size_t rows = 0;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.starts_with('#')) {
            continue;
        }
        ++rows;
        std::istringstream words(line);
        double expected = 0, tolerance = 0;
        words >> expected >> tolerance;
        std::string model;
        std::getline(words, model);
        const test::Run run = test::run(model);
        ASSERT_TRUE(run.evaluation.ok) << line << run.console;
        csg::solid::SolidCache cache;
        const csg::solid::Geometry geometry =
            csg::solid::place(*run.evaluation.tree, csg::make_scene(*run.evaluation.tree), cache);
        double sum = 0;
        for (const csg::solid::PlacedLeaf& leaf : geometry.leaves) {
            sum += test::mesh_volume(leaf.points, leaf.triangles);
            EXPECT_TRUE(is_closed(leaf)) << line;
        }
        EXPECT_NEAR(sum, expected, tolerance) << line;
    }
    EXPECT_GT(rows, 40u);
}

}  // namespace
