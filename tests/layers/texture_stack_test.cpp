// Stacks of layers in textures: what is uploaded comes back.
#include "layers/texture_stack.h"

#include <random>

#include "layers/upload.h"
#include "tests/support/gl_test.h"

namespace {

layers::HostStack random_stack(std::uint64_t seed, glm::ivec2 size, int layers) {
    std::mt19937_64 random(seed);
    layers::HostStack stack;
    stack.resize(size);
    stack.layers = layers;
    stack.reserve(static_cast<std::size_t>(layers));
    for (std::size_t i = 0; i < stack.counts.size(); ++i) {
        const std::size_t count = random() % (static_cast<std::size_t>(layers) + 1);
        for (std::size_t layer = 0; layer < count; ++layer) {
            stack.planes[layer].depth[i] = 1 - 0.1F * static_cast<float>(layer);
            stack.planes[layer].surface[i] =
                layers::encode({0, static_cast<std::uint32_t>(random() % 1000),
                                static_cast<std::uint32_t>(random() % 1000), random() % 2 == 0, random() % 2 == 0});
        }
    }
    stack.count();
    return stack;
}

class TextureStacks : public test_support::GlTest {};

TEST_P(TextureStacks, WhatIsUploadedComesBack) {
    layers::Upload upload(gl());
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const layers::HostStack stack = random_stack(seed, {37, 41}, 1 + static_cast<int>(seed % 3));
        layers::TextureStack textures = upload.upload(stack);
        const layers::HostStack back = layers::read_back(gl(), textures);
        EXPECT_EQ(back.surfaces(), stack.surfaces());
        EXPECT_EQ(back.counts, stack.counts);
        EXPECT_EQ(back.held, stack.held);
        upload.give_back(std::move(textures));
    }
}

TEST_P(TextureStacks, GrowKeepsWhatThereIs) {
    layers::Upload upload(gl());
    const layers::HostStack stack = random_stack(3, {16, 9}, 2);
    layers::TextureStack textures = upload.upload(stack);
    layers::grow(gl(), textures, 5);
    EXPECT_EQ(textures.layers, 5);
    std::vector<layers::Surface> expected = stack.surfaces();
    expected.resize(expected.size() / 2 * 5);
    EXPECT_EQ(layers::read_back(gl(), textures).surfaces(), expected);
}

TEST_P(TextureStacks, EitherSideIsReadTheSame) {
    const auto host = std::make_shared<layers::HostStack>(random_stack(5, {8, 8}, 2));
    layers::Upload upload(gl());
    const auto textures = std::make_shared<layers::TextureStack>(upload.textures({host, nullptr}));
    EXPECT_EQ(layers::in_main_memory(gl(), {host, nullptr}).get(), host.get());
    EXPECT_EQ(layers::in_main_memory(gl(), {nullptr, textures})->surfaces(), host->surfaces());
}

INSTANTIATE_TEST_SUITE_P(Contexts, TextureStacks, testing::Values(gl::ContextKind::Egl), test_support::context_name);

}  // namespace
