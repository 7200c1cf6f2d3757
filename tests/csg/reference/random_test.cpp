// Meshes of random models: closed, without self-intersection, the same by both methods, and what the picture shows.
#include <gtest/gtest.h>

#include "csg/reference/self_intersection.h"
#include "tests/csg/reference/meshes.h"

namespace {

struct Sample {
    csg::Scene scene;
    csg::solid::Geometry geometry;
};

Sample make_sample(std::uint64_t seed, random_tree::Model& model) {
    std::mt19937_64 random(seed);
    random_tree::Options options;
    if (seed % 16 == 0) {
        options = {60, 8, true};
    }
    model = random_tree::make_model(random, options);
    // Some are tiny, huge, far from the origin, or turned.
    glm::dmat4 placed(1.0);
    if (seed % 16 == 1) {
        placed = glm::dmat4(glm::dmat3(1e6));
    } else if (seed % 16 == 2) {
        placed = glm::dmat4(glm::dmat3(1e-4));
    } else if (seed % 16 == 3) {
        placed[3] = {1000, -2000, 300, 1};
    } else if (seed % 16 < 8) {
        placed = {{0.36, 0.48, -0.8, 0}, {-0.8, 0.6, 0, 0}, {0.48, 0.64, 0.6, 0}, {0, 0, 0, 1}};
    }
    model = {csg::Operation::Transform, {}, {}, placed, {}, {model}};
    const csg::Tree tree = random_tree::make_tree(model);
    Sample sample{csg::make_scene(tree), csg::solid::Geometry()};
    csg::solid::SolidCache cache;
    sample.geometry = csg::solid::place(tree, sample.scene, cache);
    return sample;
}

class RandomMeshes : public testing::TestWithParam<int> {};

TEST_P(RandomMeshes, AreClosedAndWhatThePictureShows) {
    constexpr int kSeeds = 125;
    std::size_t surfaces = 0, solid = 0;
    for (int seed = GetParam() * kSeeds; seed < (GetParam() + 1) * kSeeds; ++seed) {
        random_tree::Model model;
        const Sample sample = make_sample(static_cast<std::uint64_t>(seed), model);
        SCOPED_TRACE("seed " + std::to_string(seed));
        csg::reference::BooleanResult result;
        ASSERT_NO_THROW(result = csg::reference::make_mesh(sample.scene, sample.geometry)) << scad_text(model);
        EXPECT_NE(result.method, csg::reference::Method::Exact) << result.reason << scad_text(model);
        if (seed % 8 == 1 || seed % 8 == 5) {
            csg::reference::BooleanRequest request;
            request.method = csg::reference::Method::Exact;
            csg::reference::BooleanResult exact;
            ASSERT_NO_THROW(exact = csg::reference::make_mesh(sample.scene, sample.geometry, request))
                << scad_text(model);
            EXPECT_NEAR(result.facts.volume, exact.facts.volume, 1e-9 * exact.facts.volume) << scad_text(model);
        }
        if (result.mesh.empty()) {
            continue;
        }
        ++solid;
        const auto facts = csg::reference::facts(result.mesh);
        EXPECT_TRUE(facts.manifold) << scad_text(model);
        EXPECT_GT(facts.volume, 0);
        EXPECT_EQ(csg::reference::count_self_intersections(result.mesh, 1e-8 * facts.box.diagonal()), 0u)
            << scad_text(model);
        const auto [all, outside] = meshes::picture_errors(sample.scene, sample.geometry, result.mesh, 40);
        EXPECT_EQ(outside.coverage_wrong, 0u) << scad_text(model);
        EXPECT_EQ(outside.layers_wrong, 0u) << scad_text(model);
        EXPECT_EQ(outside.normals_wrong, 0u) << scad_text(model);
        EXPECT_LT(outside.depth_largest, 1e-5) << scad_text(model);
        surfaces += outside.surfaces;
    }
    EXPECT_GT(solid, 50u);
    EXPECT_GT(surfaces, 5000u);
}

INSTANTIATE_TEST_SUITE_P(Batches, RandomMeshes, testing::Range(0, 4));

}  // namespace
