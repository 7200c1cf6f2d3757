// Averaging of samples.
#include "npr/accumulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "npr/style_pass.h"
#include "tests/npr/scene.h"
#include "tests/support/gl_test.h"

namespace {

float linear(int byte) {
    const double c = byte / 255.0;
    return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

/// Fills the target.
class Constant : public npr::Style {
  public:
    Constant(const gl::Functions& gl, const glm::vec4& color) : gl_(gl), color_(color) {}
    void draw(const npr::Frame& frame) override {
        jitters.push_back(frame.view.jitter());
        gl_.ClearNamedFramebufferfv(frame.target.id(), GL_COLOR, 0, &color_.x);
    }
    std::vector<glm::dvec2> jitters;

  private:
    const gl::Functions& gl_;
    glm::vec4 color_;
};

class AccumulateTest : public test_support::GlTest {
  protected:
    base::Image draw(npr::Style& style, npr::Accumulator& accumulator, int samples) {
        npr::Picture picture;
        picture.size = {5, 3};
        picture.samples = samples;
        accumulator.draw(style, picture,
                         {glm::dvec3(-1), glm::dvec3(1), [](const base::View&) { return layers::TextureStack(); }});
        return accumulator.image();
    }
};

TEST_P(AccumulateTest, ConstantPictureIsExact) {
    npr::Accumulator accumulator(gl());
    for (const int samples : {1, 4, 8, 16}) {
        for (int byte = 0; byte < 256; byte += 3) {
            Constant style(gl(), {linear(byte), linear(255 - byte), linear(byte / 2), 1});
            const base::Image image = draw(style, accumulator, samples);
            ASSERT_EQ(image.rgba.size(), 5U * 3U * 4U);
            for (int i = 0; i < 15; ++i) {
                const std::uint8_t* p = image.pixel(i % 5, i / 5);
                ASSERT_EQ((std::array<int, 4>{p[0], p[1], p[2], p[3]}),
                          (std::array<int, 4>{byte, 255 - byte, byte / 2, 255}))
                    << samples << " samples";
            }
        }
    }
}

TEST_P(AccumulateTest, AlphaIsStraight) {
    npr::Accumulator accumulator(gl());
    Constant half(gl(), glm::vec4(linear(200), linear(100), linear(50), 1) * 0.4F);
    const base::Image image = draw(half, accumulator, 4);
    const std::uint8_t* p = image.pixel(2, 1);
    EXPECT_EQ((std::array<int, 4>{p[0], p[1], p[2], p[3]}), (std::array<int, 4>{200, 100, 50, 102}));
    Constant nothing(gl(), glm::vec4(0));
    const base::Image empty = draw(nothing, accumulator, 4);
    EXPECT_EQ(*std::max_element(empty.rgba.begin(), empty.rgba.end()), 0);
}

TEST_P(AccumulateTest, SamplesAreSpreadEvenly) {
    for (const auto& [asked, given] :
         {std::pair{-1, 1}, {1, 1}, {2, 4}, {4, 4}, {7, 8}, {16, 16}, {17, 64}, {99, 256}, {300, 256}}) {
        npr::Accumulator accumulator(gl());
        Constant style(gl(), glm::vec4(1));
        (void)draw(style, accumulator, asked);
        ASSERT_EQ(style.jitters.size(), static_cast<std::size_t>(given));
        std::set<int> columns, rows;
        for (const glm::dvec2& jitter : style.jitters) {
            columns.insert(static_cast<int>(std::floor((jitter.x + 0.5) * given)));
            rows.insert(static_cast<int>(std::floor((jitter.y + 0.5) * given)));
        }
        // One in each row and in each column of the pixel.
        EXPECT_EQ(columns.size(), style.jitters.size());
        EXPECT_EQ(rows.size(), style.jitters.size());
        EXPECT_EQ(*columns.begin(), 0);
        EXPECT_EQ(*columns.rbegin(), given - 1);
    }
}

TEST_P(AccumulateTest, ResolvesIntoACornerOfATarget) {
    npr::Accumulator accumulator(gl());
    Constant style(gl(), {linear(200), linear(100), linear(50), 1});
    (void)draw(style, accumulator, 4);
    const gl::Texture texture = gl::Texture::make_2d(gl(), GL_RGBA8, {12, 10});
    gl::Framebuffer target(gl());
    target.attach({&texture});
    const glm::vec4 red(1, 0, 0, 1);
    gl().ClearNamedFramebufferfv(target.id(), GL_COLOR, 0, &red.x);
    accumulator.resolve(target.id(), {4, 2});
    std::vector<std::uint8_t> pixels(12 * 10 * 4);
    gl().GetTextureImage(texture.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.size()),
                         pixels.data());
    for (std::size_t y = 0; y < 10; ++y) {
        for (std::size_t x = 0; x < 12; ++x) {
            const bool inside = x >= 4 && x < 9 && y >= 2 && y < 5;
            EXPECT_EQ(pixels[4 * (y * 12 + x) + 1], inside ? 100 : 0) << x << ", " << y;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Contexts, AccumulateTest, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

}  // namespace
