// The truth is tested by what can be worked out by hand.
#include "tests/truth/ray_caster.h"

#include <gtest/gtest.h>

#include "tests/random/build_model.h"

namespace {

using csg::Operation;
using random_tree::box;
using random_tree::combine;
using random_tree::Model;

struct Subject {
    explicit Subject(const Model& model) : tree(random_tree::make_tree(model)), scene(csg::make_scene(tree)) {
        csg::solid::SolidCache cache;
        geometry = csg::solid::place(tree, scene, cache);
    }
    [[nodiscard]] base::View view(const base::Camera& camera) const {
        return {camera, {32, 32}, geometry.box.lo, geometry.box.hi};
    }
    csg::Tree tree;
    csg::Scene scene;
    csg::solid::Geometry geometry;
};

/// From above, orthographic; the pixels' samples are a quarter of a unit apart, and off the grid.
base::Camera above() {
    base::Camera camera;
    camera.rotation = {0, 0, 0};
    camera.target = {0.03, 0.05, 0};
    camera.projection = base::Projection::Orthographic;
    camera.fov = 90;
    camera.distance = 4;
    return camera;
}

TEST(RayCaster, FindsDistancesLeavesAndCuts) {
    // A slab, with a recess from above that is filled half.
    const Model recessed = combine(Operation::Difference, {box({-3, -3, 0}, {6, 6, 2}), box({-1, -1, 1}, {2, 2, 1})});
    const Subject subject(combine(Operation::Union, {recessed, box({-1, -1, 1}, {2, 2, 0.5})}));
    const base::View view = subject.view(above());
    const truth::RayCaster caster(subject.scene, subject.geometry, view);
    const truth::Ray middle = caster.cast(16, 16), side = caster.cast(8, 16), past = caster.cast(1, 1);
    ASSERT_TRUE(middle.decided && side.decided && past.decided);
    ASSERT_EQ(middle.surfaces.size(), 2U);
    EXPECT_NEAR(middle.surfaces[0].distance, 4 - 1.5, 1e-12);
    EXPECT_EQ(middle.surfaces[0].leaves.front(), 2U);
    EXPECT_FALSE(middle.surfaces[0].leaving);
    EXPECT_NEAR(middle.surfaces[1].distance, 4, 1e-12);
    EXPECT_TRUE(middle.surfaces[1].leaving);
    ASSERT_EQ(side.surfaces.size(), 2U);
    EXPECT_NEAR(side.surfaces[0].distance, 2, 1e-12);
    EXPECT_TRUE(past.surfaces.empty() && !past.hit);
}

TEST(RayCaster, ACutIsReversed) {
    const Subject subject(combine(Operation::Difference, {box({-3, -3, 0}, {6, 6, 2}), box({-1, -1, 1}, {2, 2, 4})}));
    const base::View view = subject.view(above());
    const truth::Ray ray = truth::RayCaster(subject.scene, subject.geometry, view).cast(16, 16);
    ASSERT_EQ(ray.surfaces.size(), 2U);
    EXPECT_NEAR(ray.surfaces[0].distance, 3, 1e-12);
    EXPECT_EQ(ray.surfaces[0].reversed, std::vector<csg::LeafId>{1});
    EXPECT_TRUE(ray.surfaces[1].reversed.empty());
}

TEST(RayCaster, TheDiagonalOfAFaceIsHitOnce) {
    // Samples lie exactly on the diagonals of both faces.
    const Subject subject(box({-3, -3, 0}, {6, 6, 2}));
    base::Camera camera = above();
    camera.target = {0, 0, 0};
    const base::View view = subject.view(camera);
    const truth::RayCaster caster(subject.scene, subject.geometry, view);
    for (int i = 6; i < 26; ++i) {
        for (const int x : {i, 31 - i}) {
            const truth::Ray ray = caster.cast(x, i);
            EXPECT_TRUE(ray.decided);
            EXPECT_EQ(ray.surfaces.size(), 2U) << x << ", " << i;
        }
    }
}

TEST(RayCaster, SamplesOnABorderAreInTheBand) {
    // The border x = 3.125 is on a column of samples, x = -3.12 is not.
    const Subject subject(box({-3.12, -3, 0}, {6.245, 6, 2}));
    base::Camera camera = above();
    camera.target = {0, 0, 0};
    const base::View view = subject.view(camera);
    const truth::RayCaster caster(subject.scene, subject.geometry, view);
    for (int y = 6; y < 26; ++y) {
        for (int x = 0; x < 32; ++x) {
            EXPECT_EQ(caster.cast(x, y).decided, x != 28) << x << ", " << y;
        }
    }
}

}  // namespace
