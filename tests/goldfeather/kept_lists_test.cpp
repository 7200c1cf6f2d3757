// Pictures of a scene that is edited, drawn anew only where leaves have moved: the same as drawn whole.
#include <gtest/gtest.h>

#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "goldfeather/smooth_facets.h"
#include "tests/goldfeather/edited_scene.h"
#include "tests/random/build_model.h"

namespace {

using csg::Operation;
using edited_scene::Subject;
using random_tree::Model;

constexpr glm::ivec2 kPictureSize{330, 250};  // Tiles at two borders are not whole.

/// A plate less cylinders, and a ball beside each tenth of them.
Model plate(int side) {
    std::vector<Model> all{random_tree::box({0, 0, 0}, {4.0 * side, 4.0 * side, 2})};
    std::vector<Model> balls;
    for (int i = 0; i < side * side; ++i) {
        const glm::dvec3 at(4 * (i % side) + 2, 4 * (i / side) + 2, -1);
        all.push_back(random_tree::matrix(glm::translate(glm::dmat4(1.0), at),
                                          random_tree::leaf(csg::Cylinder{4, 1, 1, false, {12, 12, 2}})));
        if (i % 10 == 0) {
            balls.push_back(random_tree::matrix(glm::translate(glm::dmat4(1.0), at + glm::dvec3(1.5, 1.5, 3)),
                                                random_tree::leaf(csg::Sphere{1, {10, 12, 2}})));
        }
    }
    balls.push_back(random_tree::combine(Operation::Difference, std::move(all)));
    return random_tree::combine(Operation::Union, std::move(balls));
}

/// Down to the bits.
testing::AssertionResult same(const layers::HostStack& a, const layers::HostStack& b) {
    for (std::size_t layer = 0; layer < static_cast<std::size_t>(a.layers); ++layer) {
        for (std::size_t pixel = 0; pixel < a.counts.size(); ++pixel) {
            if (a.planes[layer].depth[pixel] != b.planes[layer].depth[pixel] ||
                a.planes[layer].surface[pixel] != b.planes[layer].surface[pixel]) {
                return testing::AssertionFailure() << "pixel " << pixel << " of layer " << layer;
            }
        }
    }
    return testing::AssertionSuccess();
}

TEST(KeptLists, AreAsIfDrawnWhole) {
    std::mt19937_64 random(7);
    const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    csg::solid::SolidCache cache;
    Subject subject(plate(9), cache);
    csg::solid::EditableScene scene(subject.scene, subject.geometry);
    const goldfeather::ListsModel model(subject.scene, subject.geometry);
    goldfeather::KeptLists kept;
    layers::HostStack stack;
    base::Camera camera;
    base::view_all(camera, subject.geometry.box.lo, subject.geometry.box.hi, true);
    std::uint64_t drawn = 0, whole = 0;
    std::vector<csg::LeafId> held;  // By a hand, for some steps.
    for (int step = 0; step < 120; ++step) {
        const int layers = step < 60 ? 0 : 1;
        if (step % 20 == 19) {
            camera.rotation.z += 10;  // All of it is drawn then, …
        }
        if (step % 20 == 15) {
            scene.show(0, pick(2) == 0);  // … and then.
        }
        if (step % 12 == 0) {
            held.clear();
            for (std::size_t i = 0; i < 1 + pick(3); ++i) {
                held.push_back(static_cast<csg::LeafId>(pick(subject.scene.leaves.size())));
            }
        }
        for (const csg::LeafId leaf : held) {
            const glm::dvec3 by(0.1 * static_cast<double>(pick(9)), 0.1 * static_cast<double>(pick(9)), 0);
            scene.move(leaf, glm::translate(subject.scene.leaves[leaf].to_world, by));
        }
        kept.changed(scene.commit());
        const base::View view(camera, kPictureSize, {-50, -50, -50}, {90, 90, 50});
        goldfeather::ListsStats stats, all;
        kept.peel(model, view, layers, 2, stack, stats, {});
        layers::HostStack made;
        goldfeather::peel_lists(model, view, layers, 1, made, all);
        ASSERT_EQ(stack.layers, made.layers) << step;
        ASSERT_EQ(stack.complete, made.complete) << step;
        ASSERT_EQ(stack.counts, made.counts) << step;
        ASSERT_EQ(stack.held, made.held) << step;
        ASSERT_TRUE(same(stack, made)) << step;
        EXPECT_EQ(stats.triangles, all.triangles) << step;
        EXPECT_EQ(stats.drawn_leaves, all.drawn_leaves) << step;
        EXPECT_EQ(stats.skipped_triangles, all.skipped_triangles) << step;
        drawn += stats.fragments;
        whole += all.fragments;
    }
    EXPECT_LT(drawn, whole / 2) << "most of it stays as it was";
}

TEST(KeptLists, AreForgottenWithTheirStack) {
    csg::solid::SolidCache cache;
    Subject subject(plate(3), cache);
    csg::solid::EditableScene scene(subject.scene, subject.geometry);
    const goldfeather::ListsModel model(subject.scene, subject.geometry);
    base::Camera camera;
    base::view_all(camera, subject.geometry.box.lo, subject.geometry.box.hi, true);
    const base::View view(camera, kPictureSize, subject.geometry.box.lo, subject.geometry.box.hi);
    goldfeather::KeptLists kept;
    goldfeather::ListsStats ignored;
    layers::HostStack first, second;
    kept.peel(model, view, 0, 1, first, ignored, {});
    kept.forget();
    kept.peel(model, view, 0, 1, second, ignored, {});
    EXPECT_EQ(first.counts, second.counts);
    EXPECT_TRUE(same(first, second));
    std::stop_source stop;
    stop.request_stop();
    kept.forget();
    EXPECT_ANY_THROW(kept.peel(model, view, 0, 1, second, ignored, stop.get_token()));
    kept.peel(model, view, 0, 1, second, ignored, {});
    EXPECT_EQ(first.counts, second.counts) << "what was stopped is done again";
}

TEST(SmoothFacetKeeper, HasThoseOfTheWholeScene) {
    std::mt19937_64 random(3);
    const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    csg::solid::SolidCache cache;
    Subject subject(plate(5), cache);
    csg::solid::EditableScene scene(subject.scene, subject.geometry);
    goldfeather::SmoothFacetKeeper keeper;
    int kept = 0;
    for (int step = 0; step < 60; ++step) {
        const auto leaf = static_cast<csg::LeafId>(pick(subject.scene.leaves.size()));
        const glm::dvec3 by(0.1 * static_cast<double>(pick(9)), 0.1 * static_cast<double>(pick(9)), 0);
        scene.move(leaf, glm::translate(subject.scene.leaves[leaf].to_world, by));
        const csg::solid::SceneChange change = scene.commit();
        kept += change.all_planes || change.center ? 0 : 1;
        keeper.changed(change);
        if (step % 3 == 1) {
            continue;  // Not every edit is drawn.
        }
        const layers::SmoothFacets now = keeper.facets(subject.geometry),
                                   whole = goldfeather::smooth_facets(subject.geometry);
        ASSERT_EQ(now.starts, whole.starts) << step;
        ASSERT_EQ(now.facets.size(), whole.facets.size()) << step;
        for (std::size_t i = 0; i < now.facets.size(); ++i) {
            ASSERT_EQ(now.facets[i].first, whole.facets[i].first) << step;
            ASSERT_EQ(now.facets[i].second, whole.facets[i].second) << step;
            ASSERT_EQ(now.facets[i].normals, whole.facets[i].normals) << step;
        }
    }
    EXPECT_GT(kept, 10);
}

}  // namespace
