// Sequenced convex subtraction against the ray caster.
#include "goldfeather/scs/scs.h"

#include <fmt/format.h>

#include <iostream>

#include "goldfeather/engine_set.h"
#include "tests/goldfeather/engine_test.h"
#include "tests/random/build_model.h"

namespace {

using comparison::Subject;
using csg::Operation;
using random_tree::at;
using random_tree::box;
using random_tree::combine;
using random_tree::leaf;
using random_tree::Model;

constexpr glm::ivec2 kSize{48, 48};

std::string obstacle(const Subject& subject, const base::View& view, int max_layers = 1) {
    for (const auto& products : subject.products) {
        std::string reason = goldfeather::Scs::obstacle(view, subject.geometry, products, max_layers);
        if (!reason.empty()) {
            return reason;
        }
    }
    return {};
}

class ScsOnOpenGl : public test_support::GlTest {
  protected:
    std::unique_ptr<goldfeather::Engine> make(std::size_t memory_budget = goldfeather::kDefaultMemoryBudget) {
        return goldfeather::make_engine(*goldfeather::find_engine("scs"), {&gl(), memory_budget});
    }
    /// What is wrong with the first layer; empty if nothing is.
    std::string wrong(goldfeather::Engine& engine, const Subject& subject, const base::View& view,
                      comparison::Count& count) {
        return comparison::difference(subject, view, comparison::peel_all(gl(), engine, subject, view, 1), count, 1);
    }
};

TEST_P(ScsOnOpenGl, RandomTreesAgreeWithTheRayCaster) {
    const auto engine = make();
    comparison::Count count;
    int drawn = 0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        std::mt19937_64 random(seed);
        random_tree::Options options;
        if (seed % 16 == 0) {
            options = {40, 6, true};
        }
        const Model model = random_tree::make_model(random, options);
        const Subject subject(random_tree::make_tree(model));
        const base::View view =
            subject.view(random_tree::make_camera(random, subject.geometry.box.lo, subject.geometry.box.hi), kSize);
        if (subject.over_budget > 0 || !obstacle(subject, view).empty()) {
            continue;
        }
        ++drawn;
        ASSERT_EQ(wrong(*engine, subject, view, count), "") << "seed " << seed << '\n' << random_tree::scad_text(model);
    }
    std::cout << fmt::format("{} of 1000 trees, {} surfaces compared, {} of {} pixels in the band\n", drawn,
                             count.surfaces, count.undecided, count.pixels);
    EXPECT_GT(drawn, 300);
    EXPECT_GT(count.surfaces, 100000U);
}

/// Every order of overlapping holes is a subsequence of the rounds.
TEST_P(ScsOnOpenGl, OverlappingHolesInAnyOrder) {
    const auto engine = make();
    std::vector<Model> holes;
    for (int i = 0; i < 9; ++i) {
        // Slabs that overlap their neighbors, in an order that is neither front to back nor back to front.
        const int k = (4 * i) % 9;
        holes.push_back(box({-2 + 0.1 * k, -2, -9 + 2.0 * k}, {4, 4, 2.5}));
    }
    std::vector<Model> all{box({-4, -4, -10}, {8, 8, 20})};
    all.insert(all.end(), holes.begin(), holes.end());
    const Subject subject(random_tree::make_tree(combine(Operation::Difference, all)));
    for (const glm::dvec3& eye : {glm::dvec3(0.5, 1, 50), glm::dvec3(0.5, 1, -50), glm::dvec3(30, 20, 40)}) {
        const base::View view = subject.view(base::camera_between(eye, {0, 0, 0}), kSize);
        comparison::Count count;
        EXPECT_EQ(wrong(*engine, subject, view, count), "");
    }
}

TEST_P(ScsOnOpenGl, SharedFacesHaveNoSkin) {
    const auto engine = make();
    const Model plate = combine(Operation::Difference, {box({-4, -4, 0}, {8, 8, 1}), box({-1, -1, 0}, {2, 2, 1})});
    const Model same = combine(Operation::Difference, {box({0, 0, 0}, {2, 3, 4}), box({0, 0, 0}, {2, 3, 4})});
    for (const Model& model : {plate, same}) {
        const Subject subject(random_tree::make_tree(model));
        for (const glm::dvec3& eye : {glm::dvec3(0.1, 0.2, 20), glm::dvec3(3, -8, 15), glm::dvec3(0.1, 0.1, -20)}) {
            const base::View view = subject.view(base::camera_between(eye, {0.05, 0.06, 0.5}), kSize);
            comparison::Count count;
            EXPECT_EQ(wrong(*engine, subject, view, count), "");
        }
    }
}

/// Memory is split in bands that do not show.
TEST_P(ScsOnOpenGl, BandsDoNotShow) {
    const auto whole = make(), split = make(48 * 36 * 5);
    const Subject subject(random_tree::make_tree(
        combine(Operation::Difference, {box({-4, -4, 0}, {8, 8, 2}), at({1, 0, 0}, leaf(csg::Sphere{2, {12, 12, 2}})),
                                        leaf(csg::Cylinder{9, 1, 1, true, {9, 12, 2}})})));
    const base::View view = subject.view(base::camera_between({9, 8, 17}, {0, 0, 0}), kSize);
    const auto a = comparison::peel_all(gl(), *whole, subject, view, 1);
    const auto b = comparison::peel_all(gl(), *split, subject, view, 1);
    EXPECT_EQ(a.surfaces(), b.surfaces());
}

/// What the method cannot do is said, and drawn by another engine.
TEST_P(ScsOnOpenGl, KnowsItsLimits) {
    const Model solid = combine(Operation::Difference, {box({-4, -4, 0}, {8, 8, 2}), box({-1, -1, 1}, {2, 2, 1})});
    const Subject subject(random_tree::make_tree(solid));
    const base::View outside = subject.view(base::camera_between({9, 8, 17}, {0, 0, 0}), kSize);
    const base::View inside = subject.view(base::camera_between({2, 2, 1}, {0, 0, 1}), kSize);
    csg::Polyhedron arrow;  // A prism over a polygon that is not convex.
    arrow.points = {{0, 0, 0}, {4, 2, 0}, {0, 4, 0}, {1, 2, 0}, {0, 0, 1}, {4, 2, 1}, {0, 4, 1}, {1, 2, 1}};
    arrow.faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    const Subject hollow(random_tree::make_tree(leaf(std::make_shared<const csg::Polyhedron>(arrow))));

    EXPECT_EQ(obstacle(subject, outside), "");
    EXPECT_NE(obstacle(subject, outside, 2), "");
    EXPECT_NE(obstacle(subject, outside, goldfeather::kAllLayers), "");
    EXPECT_NE(obstacle(subject, inside), "");
    EXPECT_NE(obstacle(hollow, hollow.view(base::camera_between({9, 8, 17}, {0, 0, 0}), kSize)), "");

    goldfeather::EngineSet engines({&gl()});
    const auto scene = engines.prepare(subject.input(), *goldfeather::find_engine("scs"));
    goldfeather::WalkStats stats;
    const auto layers = layers::in_main_memory(gl(), scene->draw(outside, 0, stats));
    EXPECT_EQ(stats.fallback, "scs finds one layer only");
    comparison::Count count;
    EXPECT_EQ(comparison::difference(subject, outside, *layers, count), "");
}

INSTANTIATE_TEST_SUITE_P(Contexts, ScsOnOpenGl, testing::Values(gl::ContextKind::Egl), test_support::context_name);

}  // namespace
