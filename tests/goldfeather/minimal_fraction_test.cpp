// Ending before layers that few pixels have.
#include <algorithm>

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "tests/goldfeather/engine_test.h"
#include "tests/random/build_model.h"

namespace {

using comparison::Subject;
using random_tree::box;

constexpr glm::ivec2 kSize{64, 64};
constexpr double kPixels = 64.0 * 64.0;

/// A plate with a stack of ten thin plates in one corner: few pixels have many layers.
Subject plate_with_stack() {
    std::vector<random_tree::Model> children{box({0, 0, 0}, {10, 10, 1})};
    for (int i = 0; i < 10; ++i) {
        children.push_back(box({1, 1, 2.0 + i}, {1, 1, 0.5}));
    }
    return Subject(random_tree::make_tree(random_tree::combine(csg::Operation::Union, children)));
}

base::View from_above(const Subject& subject) {
    base::Camera camera;
    camera.projection = base::Projection::Orthographic;
    camera.rotation = {0, 0, 0};
    base::view_all(camera, subject.geometry.box.lo, subject.geometry.box.hi, true);
    return subject.view(camera, kSize);
}

std::size_t pixels_with(const layers::HostStack& stack, int layer) {
    std::size_t count = 0;
    for (int y = 0; layer < stack.layers && y < stack.size.y; ++y) {
        for (int x = 0; x < stack.size.x; ++x) {
            count += stack.at(layer, x, y).depth > 0 ? 1 : 0;
        }
    }
    return count;
}

TEST(MinimalFraction, ListsLeaveOutLayersThatFewPixelsHave) {
    const Subject subject = plate_with_stack();
    const goldfeather::ListsModel model(subject.scene, subject.geometry);
    layers::HostStack layers;
    goldfeather::ListsStats stats;
    const auto peel = [&](double minimal_fraction) {
        goldfeather::peel_lists(model, from_above(subject), 0, 1, layers, stats);
        layers::leave_out_sparse_layers(layers, minimal_fraction);
        return layers;
    };
    const auto all = peel(0);
    ASSERT_EQ(all.layers, 22);
    EXPECT_TRUE(layers.complete);
    const std::size_t few = pixels_with(all, 21), many = pixels_with(all, 1);
    ASSERT_GT(few, 4U);
    ASSERT_GT(many, 10 * few);
    EXPECT_EQ(peel(static_cast<double>(few) / kPixels).layers, 22);  // Just as many.
    const auto less = peel((static_cast<double>(few) + 1) / kPixels);
    EXPECT_EQ(less.layers, 2);
    EXPECT_FALSE(layers.complete);
    EXPECT_EQ(less.surfaces(), comparison::padded(all, 2));
    EXPECT_EQ(peel(1).layers, 1);                   // The first one stays.
    EXPECT_EQ(peel(0).surfaces(), all.surfaces());  // And the next picture has all again.
}

class MinimalFractionOfTheWalk : public test_support::GlTest {};

TEST_P(MinimalFractionOfTheWalk, FewerPixelsThanThatLackSomething) {
    const Subject subject = plate_with_stack();
    const base::View view = from_above(subject);
    const auto peel = [&](double minimal_fraction, goldfeather::WalkStats& stats) {
        const auto engine = goldfeather::make_engine(*goldfeather::find_engine("goldfeather"),
                                                     {.gl = &gl(), .minimal_fraction = minimal_fraction});
        const auto scene = engine->prepare(subject.input());
        const layers::HostStack stack =
            *layers::in_main_memory(gl(), scene->draw(view, goldfeather::kAllLayers, stats));
        EXPECT_EQ(stack.complete, minimal_fraction == 0);
        return stack;
    };
    goldfeather::WalkStats all_stats, less_stats;
    const auto all = peel(0, all_stats);
    ASSERT_EQ(all.layers, 22);
    const double fraction = 2 * static_cast<double>(pixels_with(all, 21)) / kPixels;
    const auto less = peel(fraction, less_stats);
    EXPECT_LT(less_stats.passes, all_stats.passes);
    EXPECT_LT(less.layers, all.layers);
    std::size_t lacking = 0;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            bool lacks = false;
            for (int layer = 0; layer < all.layers; ++layer) {
                if (layer < less.layers && less.at(layer, x, y).depth > 0) {
                    EXPECT_EQ(less.at(layer, x, y), all.at(layer, x, y));
                } else {
                    lacks = lacks || all.at(layer, x, y).depth > 0;
                }
            }
            lacking += lacks ? 1 : 0;
        }
    }
    EXPECT_GT(lacking, 0U);
    EXPECT_LT(static_cast<double>(lacking), fraction * kPixels);
}

INSTANTIATE_TEST_SUITE_P(Contexts, MinimalFractionOfTheWalk, testing::Values(gl::ContextKind::Egl),
                         test_support::context_name);

}  // namespace
