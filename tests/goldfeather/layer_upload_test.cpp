// Layers of lists-cpu in textures that are used again from picture to picture.
#include "goldfeather/lists_cpu/lists_cpu.h"
#include "layers/upload.h"
#include "tests/goldfeather/engine_test.h"

namespace {

class LayerUploads : public test_support::GlTest {};

TEST_P(LayerUploads, TexturesUsedAgainHoldJustTheNewPicture) {
    const auto engine = goldfeather::make_engine(*goldfeather::find_engine("lists-cpu"), {});
    layers::Upload upload(gl());
    std::size_t used_again = 0;
    GLuint before = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        std::mt19937_64 random(seed);
        const comparison::Subject subject(random_tree::make_tree(random_tree::make_model(random)), false);
        const auto scene = engine->prepare(subject.input());
        for (int picture = 0; picture < 4; ++picture) {
            const base::Camera camera =
                random_tree::make_camera(random, subject.geometry.box.lo, subject.geometry.box.hi);
            // Of a size that is no multiple of the tiles'.
            const base::View view = subject.view(camera, {75, 70});
            const int layers = picture % 2 == 0 ? goldfeather::kAllLayers : 2;
            goldfeather::WalkStats stats;
            layers::TextureStack stack = upload.textures(scene->draw(view, layers, stats));
            used_again += stack.depth.id() == before ? 1 : 0;
            before = stack.depth.id();

            const auto expected = goldfeather::peel_to_host(subject.scene, subject.geometry, view, layers, 1);
            const auto actual = layers::read_back(gl(), stack);
            ASSERT_EQ(actual.layers, expected.layers) << "seed " << seed;
            ASSERT_EQ(actual.surfaces(), expected.surfaces()) << "seed " << seed << ", picture " << picture;
            upload.give_back(std::move(stack));
        }
    }
    EXPECT_GT(used_again, 20U);
}

INSTANTIATE_TEST_SUITE_P(Contexts, LayerUploads, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

}  // namespace
