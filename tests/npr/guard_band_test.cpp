// Lines at the border of a picture are what they are in a larger one.
#include "npr/guard_band.h"

#include "tests/npr/easel.h"
#include "tests/support/gl_test.h"

namespace {

constexpr int kTile = 90;

npr::Picture whole(std::string_view style, const csg::Box& box) {
    npr::Picture p = npr::default_picture();
    p.draw_as(*npr::find_style(style));
    p.camera = scene::camera(box);
    p.camera.projection = base::Projection::Orthographic;
    p.size = {2 * kTile, 2 * kTile};
    p.samples = 1;
    return p;
}

/// One of the four quarters of the picture.
npr::Picture quarter(const npr::Picture& all, int column, int row) {
    npr::Picture p = all;
    p.size = {kTile, kTile};
    p.camera.distance /= 2;
    const double half = all.camera.distance * std::tan(glm::radians(all.camera.fov) / 2);
    const glm::dmat4 turn = glm::transpose(all.camera.eye_from_world());
    p.camera.target += (column - 0.5) * half * glm::dvec3(turn[0]) + (row - 0.5) * half * glm::dvec3(turn[1]);
    return p;
}

/// Of the pixels of all quarters, how many are other than in the whole picture by more than 2/255.
int other_in_tiles(const base::Image& all, const std::function<base::Image(int column, int row)>& tile) {
    int count = 0;
    for (int i = 0; i < 4; ++i) {
        const base::Image image = tile(i % 2, i / 2);
        EXPECT_EQ(image.width, kTile);
        for (int y = 0; y < kTile; ++y) {
            for (int x = 0; x < kTile; ++x) {
                const std::uint8_t* a = image.pixel(x, y);
                const std::uint8_t* b = all.pixel(x + kTile * (i % 2), y + kTile * (1 - i / 2));
                int worst = 0;
                for (int c = 0; c < 4; ++c) {
                    worst = std::max(worst, std::abs(a[c] - b[c]));
                }
                count += worst > 2 ? 1 : 0;
            }
        }
    }
    return count;
}

class GuardBandTest : public test_support::GlTest {};

TEST(GuardBand, TilesAreRegionsOfTheLargerPicture) {
    scene::Easel easel(scene::widget());
    for (const char* style : {"lines", "gooch", "hatch", "blueprint", "tech"}) {
        const npr::Picture all = whole(style, easel.box());
        EXPECT_LE(other_in_tiles(easel.paint(all),
                                 [&](int column, int row) { return easel.paint(quarter(all, column, row)); }),
                  3)
            << style;
    }
}

TEST_P(GuardBandTest, TheSameWithOpenGl) {
    scene::Easel easel(scene::widget());
    const npr::Picture all = whole("lines", easel.box());
    EXPECT_LE(other_in_tiles(easel.draw(gl(), all),
                             [&](int column, int row) { return easel.draw(gl(), quarter(all, column, row)); }),
              3);
}

TEST(GuardBand, IsAsWideAsLinesReach) {
    npr::Picture p = npr::default_picture();
    EXPECT_EQ(npr::with_guard_band(p).size, p.size) << "shaded has none";
    p.draw_as(*npr::find_style("lines"));
    p.parameters.read("width", "3");
    const npr::Picture wide = npr::with_guard_band(p);
    EXPECT_EQ(wide.guard, npr::reach_of_lines(3));
    EXPECT_EQ(wide.size, p.size + 2 * wide.guard);
    const auto pixel = [](const npr::Picture& q) { return std::tan(glm::radians(q.camera.fov) / 2) / q.size.y; };
    EXPECT_NEAR(pixel(wide), pixel(p), 1e-12);
    p.size = {16384, 20};
    EXPECT_EQ(npr::with_guard_band(p).size, p.size) << "as large as pictures may be";
    p = npr::default_picture();
    p.part_styles.push_back({{}, npr::find_style("lines"), npr::Parameters(npr::find_style("lines")->parameters)});
    EXPECT_GT(npr::with_guard_band(p).guard, 0) << "a part has lines";
}

INSTANTIATE_TEST_SUITE_P(Contexts, GuardBandTest, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

}  // namespace
