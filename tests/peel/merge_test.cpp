// Two stacks as one.
#include "peel/merge.h"

#include <algorithm>
#include <random>

#include "layers/upload.h"
#include "tests/support/gl_test.h"

namespace {

constexpr glm::ivec2 kSize{19, 13};

/// Depths from a few values, so that they often agree between stacks.
layers::HostStack random_stack(std::mt19937_64& random, int layers, std::uint32_t first_leaf) {
    layers::HostStack stack;
    stack.resize(kSize);
    stack.layers = layers;
    stack.complete = true;
    stack.reserve(static_cast<std::size_t>(layers));
    for (std::size_t i = 0; i < stack.counts.size(); ++i) {
        int step = 8;
        for (std::size_t layer = 0; layer < static_cast<std::size_t>(layers); ++layer) {
            step -= 1 + static_cast<int>(random() % 4);
            if (step <= 0) {
                break;
            }
            stack.planes[layer].depth[i] = static_cast<float>(step) / 8;
            stack.planes[layer].surface[i] =
                layers::encode({0, first_leaf + static_cast<std::uint32_t>(layer), 7, false, layer % 2 == 1});
        }
    }
    stack.count();
    return stack;
}

/// The surfaces of a pixel of both, nearest first; those of `front` come first at equal depth.
std::vector<layers::Surface> expected(const layers::HostStack& front, const layers::HostStack& back, int x, int y,
                                      int layers) {
    std::vector<layers::Surface> all;
    for (const layers::HostStack* stack : {&front, &back}) {
        for (int layer = 0; layer < stack->layers && stack->at(layer, x, y).depth > 0; ++layer) {
            all.push_back(stack->at(layer, x, y));
        }
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.depth > b.depth; });
    all.resize(static_cast<std::size_t>(layers));
    return all;
}

class Merges : public test_support::GlTest {};

TEST_P(Merges, AreSortedByDepthAndTheFirstComesFirst) {
    peel::Merge merge(gl());
    std::mt19937_64 random(1);
    for (const int most : {0, 1, 2, 5}) {
        layers::Upload to_front(gl()), to_back(gl());
        const layers::HostStack front = random_stack(random, 3, 0), back = random_stack(random, 4, 100);
        const layers::TextureStack merged = merge(to_front.upload(front), to_back.upload(back), most);
        EXPECT_EQ(merged.layers, most == 0 ? 7 : most);
        EXPECT_EQ(merged.complete, most == 0);
        const layers::HostStack found = layers::read_back(gl(), merged);
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const auto pixel = expected(front, back, x, y, merged.layers);
                for (int layer = 0; layer < merged.layers; ++layer) {
                    ASSERT_EQ(found.at(layer, x, y), pixel[static_cast<std::size_t>(layer)])
                        << x << ", " << y << ", layer " << layer;
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Contexts, Merges, testing::Values(gl::ContextKind::Egl), test_support::context_name);

}  // namespace
