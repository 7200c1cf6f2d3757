// Pictures for the window: the same whether they are drawn at once or by a thread.
#include "ui/viewer/picture_view.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "gl/error.h"
#include "tests/support/gl_test.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/viewer/small_model.h"

namespace ui {
namespace {

using namespace std::chrono_literals;

class PictureViewTest : public test_support::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (!context_) {
            return;
        }
        request_.size = {96, 64};
        request_.camera.distance = 60;
        request_.camera.target = {8, 5, 2};  // Not in the middle: the picture has no symmetry.
    }

    PictureView make(bool threaded) {
        return {*context_, {}, threaded, [] {}};
    }
    /// Waits for one result.
    template <typename Result>
    static Result wait(PictureView& view) {
        for (int i = 0; i < 6000; ++i) {
            for (const PictureResult& result : view.take()) {
                return std::get<Result>(result);
            }
            std::this_thread::sleep_for(5ms);
        }
        ADD_FAILURE() << "no result";
        return {};
    }
    /// What `show` puts into a framebuffer, rows from bottom to top.
    std::vector<std::uint8_t> shown(const PictureView& view, glm::ivec2 size) {
        const gl::Texture texture = gl::Texture::make_2d(gl(), GL_RGBA8, size);
        gl::Framebuffer target(gl());
        target.attach({&texture});
        view.show(target.id(), {0, 0}, size, glm::vec3(0.5F));
        const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
        std::vector<std::uint8_t> rgba(4 * pixels);
        gl().GetTextureImage(texture.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(rgba.size()),
                             rgba.data());
        return rgba;
    }
    std::vector<std::uint8_t> drawn(bool threaded, int samples) {
        PictureView view = make(threaded);
        request_.samples = 4;
        for (int sample = 0; sample < samples; ++sample) {
            view.draw(model_, request_, {}, {}, {1, sample}, 7);
            const auto done = wait<DrawnStep>(view);
            EXPECT_EQ(done.error, "");
            EXPECT_EQ(done.version, 7U);
            EXPECT_EQ(done.step.sample, sample);
            EXPECT_EQ(done.statistics.samples, sample + 1);
        }
        return shown(view, request_.size);
    }

    std::shared_ptr<const Model> model_ = cube_model();
    PictureRequest request_;
};

TEST_P(PictureViewTest, DrawsTheSameWithAndWithoutAThread) {
    for (const int samples : {1, 4}) {
        const auto at_once = drawn(false, samples);
        EXPECT_EQ(drawn(true, samples), at_once);
        const std::vector<std::uint8_t> background{255, 255, 229, 255};
        EXPECT_TRUE(std::equal(background.begin(), background.end(), at_once.begin()));
        std::vector<std::uint8_t> flipped;
        for (std::size_t y = 64; y-- > 0;) {
            flipped.insert(flipped.end(), at_once.begin() + static_cast<std::ptrdiff_t>(y * 96 * 4),
                           at_once.begin() + static_cast<std::ptrdiff_t>((y + 1) * 96 * 4));
        }
        EXPECT_NE(flipped, at_once) << "this test would see a picture upside down";
    }
}

TEST_P(PictureViewTest, AllSamplesMakeThePictureOfTheCommandLine) {
    const auto steps = drawn(false, 4);
    const base::Image whole = Renderer(*context_).render(*model_, request_);
    for (int y = 0; y < whole.height; ++y) {
        const auto row = static_cast<std::size_t>(whole.height - 1 - y) * 96 * 4;
        ASSERT_TRUE(std::equal(whole.pixel(0, y), whole.pixel(0, y) + 96 * 4, &steps[row])) << "row " << y;
    }
}

TEST_P(PictureViewTest, AStepThatIsStoppedShowsNothingAndTheNextIsRight) {
    const auto expected = drawn(true, 1);
    PictureView view = make(true);
    PictureRequest large = request_;
    large.size = {2000, 2000};
    for (int i = 0; i < 3; ++i) {
        view.draw(model_, large, {}, {}, {1, 0}, 1);
        std::this_thread::sleep_for(i * 5ms);
        view.stop_drawing();
        EXPECT_TRUE(wait<DrawnStep>(view).stopped);
    }
    EXPECT_EQ(shown(view, {8, 8})[0], 128) << "nothing is drawn yet";
    request_.samples = 4;
    view.draw(model_, request_, {}, {}, {1, 0}, 2);
    EXPECT_FALSE(wait<DrawnStep>(view).stopped);
    EXPECT_EQ(shown(view, request_.size), expected);
}

TEST_P(PictureViewTest, ACoarsePictureFillsItsPlace) {
    for (const bool threaded : {false, true}) {
        PictureView view = make(threaded);
        EXPECT_EQ(shown(view, {8, 8})[0], 128) << "nothing is drawn yet";
        view.draw(model_, request_, {}, {}, {4, 0}, 1);
        (void)wait<DrawnStep>(view);
        const auto coarse = shown(view, request_.size);
        const auto differs = std::count_if(coarse.begin(), coarse.end(), [&](auto c) { return c != coarse[0]; });
        EXPECT_GT(differs, 500) << "the model is there";
    }
}

TEST_P(PictureViewTest, PicksThePointInTheMiddle) {
    for (const bool threaded : {false, true}) {
        PictureView view = make(threaded);
        base::Camera camera;
        camera.rotation = {0, 0, 0};
        camera.target = {4, 3, 0};
        camera.fov = 0.1;
        view.pick(model_, {}, camera);
        const auto hit = wait<PickedPoint>(view);
        ASSERT_TRUE(hit.surface.has_value());
        EXPECT_NEAR(glm::distance(hit.surface->point, glm::dvec3(4, 3, 10)), 0, 1e-3);
        camera.target = {40, 3, 0};
        view.pick(model_, {}, camera);
        EXPECT_FALSE(wait<PickedPoint>(view).surface.has_value());
    }
}

TEST_P(PictureViewTest, ThicknessHasTheTintsOfTheCommandLineAndPicksGoOn) {
    const ThicknessRequest wall{ThicknessRequest::What::Wall, false, 20.0};
    request_.samples = 4;
    PictureRequest white = request_;
    white.scheme.face = white.scheme.cut = glm::vec3(1);
    Renderer renderer(*context_);
    const auto plain = without_colors(*model_);
    base::Image whole = renderer.render(*plain, white);
    tint(whole, thickness_map(renderer, *model_, *plain, white, wall));
    for (const bool threaded : {false, true}) {
        PictureView view = make(threaded);
        for (int sample = 0; sample < 4; ++sample) {
            view.draw(model_, request_, {}, wall, {1, sample}, 1);
            const auto done = wait<DrawnStep>(view);
            ASSERT_EQ(done.error, "");
            ASSERT_NE(done.thickness, nullptr);
            EXPECT_EQ(done.thickness->range, 20);
            ASSERT_FALSE(done.thickness->places.empty());
            EXPECT_NEAR(done.thickness->places[0].value, 10, 1e-9);
            base::Camera camera = request_.camera;
            camera.target = {4, 3, 10};
            view.pick(model_, {}, camera);
            EXPECT_TRUE(wait<PickedPoint>(view).surface.has_value());
        }
        const auto steps = shown(view, request_.size);
        for (int y = 0; y < whole.height; ++y) {
            const auto row = static_cast<std::size_t>(whole.height - 1 - y) * 96 * 4;
            ASSERT_TRUE(std::equal(whole.pixel(0, y), whole.pixel(0, y) + 96 * 4, &steps[row])) << "row " << y;
        }
        view.draw(model_, request_, {}, {}, {1, 0}, 2);
        EXPECT_EQ(wait<DrawnStep>(view).thickness, nullptr);
        EXPECT_NE(shown(view, request_.size), steps) << "its colors are there again";
    }
}

TEST_P(PictureViewTest, SavesOrSaysWhyNot) {
    const test_support::TemporaryFolder folder;
    for (const bool threaded : {false, true}) {
        PictureView view = make(threaded);
        view.save(model_, request_, {}, folder.path("saved.png"));
        EXPECT_EQ(wait<SavedPicture>(view).error, "");
        EXPECT_EQ(base::read_png(folder.path("saved.png")).width, 96);
        view.save(model_, request_, {}, "/nowhere/at/all.png");
        EXPECT_NE(wait<SavedPicture>(view).error.find("/nowhere/at/all.png"), std::string::npos);
    }
}

TEST_P(PictureViewTest, AnErrorIsAResult) {
    for (const bool threaded : {false, true}) {
        PictureView view = make(threaded);
        static const npr::StyleInfo broken{
            "broken",
            "Broken",
            {},
            [](const gl::Functions&) -> std::unique_ptr<npr::Style> { throw gl::Error("no such style"); },
            []() -> npr::Paint { throw gl::Error("no such style"); }};
        request_.draw_as(broken);
        view.draw(model_, request_, {}, {}, {1, 0}, 1);
        EXPECT_EQ(wait<DrawnStep>(view).error, "no such style");
    }
}

TEST_P(PictureViewTest, ItsEndDropsWhatWaits) {
    PictureView view = make(true);
    for (int i = 0; i < 50; ++i) {
        view.draw(model_, request_, {}, {}, {1, 0}, 1);
    }
    EXPECT_TRUE(view.busy());
}

INSTANTIATE_TEST_SUITE_P(Contexts, PictureViewTest, testing::Values(gl::ContextKind::Egl), test_support::context_name);

}  // namespace
}  // namespace ui
