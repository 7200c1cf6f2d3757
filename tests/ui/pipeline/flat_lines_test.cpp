// Lines of flat models: which pixels they cover.
#include "ui/pipeline/picture/flat_lines.h"

#include <gtest/gtest.h>

#include <string>

namespace {

using csg::solid::Loop;

constexpr int kWidth = 16, kHeight = 8;

/// '#' where there is a line; a unit is a pixel, and the picture's lower left corner is at the origin.
std::string drawn(const std::vector<Loop>& loops) {
    base::Camera camera;
    camera.target = {kWidth / 2.0, kHeight / 2.0, 0};
    camera.rotation = {0, 0, 0};
    camera.projection = base::Projection::Orthographic;
    // The distance at which the picture is kHeight units high.
    camera.distance = 100;
    const double high = 2 * base::View(camera, {kWidth, kHeight}, {0, 0, 0}, {16, 8, 0}).half_height();
    camera.distance *= kHeight / high;
    base::Image image{kWidth, kHeight, std::vector<std::uint8_t>(std::size_t{4} * kWidth * kHeight, 0)};
    ui::draw_flat_lines(image, {loops}, camera, {1, 0, 0});
    std::string text;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            text += image.pixel(x, y)[0] == 255 && image.pixel(x, y)[3] == 255 ? '#' : '.';
        }
        text += '\n';
    }
    return text;
}

TEST(FlatLines, AreTwoPixelsWideAboutTheOutline) {
    EXPECT_EQ(drawn({{{3.1, 2.1}, {12.1, 2.1}, {12.1, 6.1}, {3.1, 6.1}}}),
              "................\n"
              "...#########....\n"
              "..###########...\n"
              "..##.......##...\n"
              "..##.......##...\n"
              "..###########...\n"
              "...#########....\n"  // Corners stay open, as OpenGL's.
              "................\n");
}

TEST(FlatLines, ShowWhatIsThinnerThanAPixel) {
    EXPECT_EQ(drawn({{{2.1, 4.6}, {13.1, 4.6}, {13.1, 4.7}, {2.1, 4.7}}}),
              "................\n"
              "................\n"
              "..###########...\n"
              "..###########...\n"
              "................\n"
              "................\n"
              "................\n"
              "................\n");
}

TEST(FlatLines, SlantedOnesHaveTwoPixelsInEveryColumn) {
    const std::string picture = drawn({{{1.2, 1.2}, {14.2, 5.2}, {14.2, 5.2}}});
    for (int x = 1; x < 14; ++x) {
        int covered = 0;
        for (int y = 0; y < kHeight; ++y) {
            covered += picture[static_cast<std::size_t>(y * (kWidth + 1) + x)] == '#' ? 1 : 0;
        }
        EXPECT_EQ(covered, 2) << x;
    }
}

TEST(FlatLines, OutsideThePictureAreCutOff) {
    EXPECT_EQ(drawn({{{-1e9, -1e9}, {1e9, -1e9}, {1e9, 1e9}, {-1e9, 1e9}}}).find('#'), std::string::npos);
    EXPECT_EQ(drawn({}).find('#'), std::string::npos);
}

}  // namespace
