// Stacks of layers in main memory.
#include "layers/host_stack.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using layers::HostStack;

/// Pixel i has i mod 4 layers.
HostStack steps(glm::ivec2 size) {
    HostStack stack;
    stack.resize(size);
    stack.layers = 3;
    stack.complete = true;
    stack.reserve(3);
    for (std::size_t i = 0; i < stack.counts.size(); ++i) {
        for (std::size_t layer = 0; layer < i % 4; ++layer) {
            stack.planes[layer].depth[i] = 0.9F - 0.1F * static_cast<float>(layer);
            stack.planes[layer].surface[i] = layers::encode(
                {0, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(layer), false, layer == 1});
        }
    }
    stack.count();
    return stack;
}

TEST(HostStack, CountsByPixelAndByTile) {
    const HostStack stack = steps({40, 3});
    ASSERT_EQ(stack.counts.size(), 120U);
    for (std::size_t i = 0; i < stack.counts.size(); ++i) {
        EXPECT_EQ(stack.counts[i], static_cast<int>(i % 4));
    }
    EXPECT_EQ(stack.held, (std::vector<int>{3, 3}));  // Tiles of 32 pixels.
}

TEST(HostStack, GivesSurfacesOneByOneAndAllTogether) {
    const HostStack stack = steps({5, 2});
    const auto all = stack.surfaces();
    ASSERT_EQ(all.size(), 30U);
    EXPECT_EQ(stack.at(1, 2, 1), (layers::Surface{0.9F - 0.1F, 7, 1, false, true}));
    EXPECT_EQ(stack.at(2, 1, 1), layers::Surface{});
    for (int layer = 0; layer < 3; ++layer) {
        for (int y = 0; y < 2; ++y) {
            for (int x = 0; x < 5; ++x) {
                EXPECT_EQ(stack.at(layer, x, y), all[static_cast<std::size_t>((layer * 2 + y) * 5 + x)]);
            }
        }
    }
}

TEST(HostStack, KeepsItsMemoryForTheSameSizeOnly) {
    HostStack stack = steps({8, 8});
    const float* depth = stack.planes[0].depth.data();
    stack.resize({8, 8});
    EXPECT_EQ(stack.planes[0].depth.data(), depth);
    stack.resize({4, 9});
    EXPECT_TRUE(stack.planes.empty());
    EXPECT_EQ(stack.counts.size(), 36U);
    EXPECT_EQ(std::count(stack.held.begin(), stack.held.end(), 0), 1);
}

TEST(HostStack, SparseLayersAreLeftOutFromTheLast) {
    const auto left = [](double fraction) {
        HostStack stack = steps({40, 3});
        layers::leave_out_sparse_layers(stack, fraction);
        EXPECT_EQ(stack.complete, stack.layers == 3);
        return stack.layers;
    };
    EXPECT_EQ(left(0), 3);
    EXPECT_EQ(left(0.25), 3);  // Just as many.
    EXPECT_EQ(left(0.26), 2);
    EXPECT_EQ(left(0.6), 1);
    EXPECT_EQ(left(1), 1);  // The first one stays.
}

}  // namespace
