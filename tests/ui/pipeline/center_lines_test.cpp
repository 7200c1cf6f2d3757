// Which axes a model has, and what is drawn along them.
#include "ui/pipeline/picture/center_lines.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/csg/scad/evaluate_text.h"

namespace ui {
namespace {

std::shared_ptr<const Model> model_of(const std::string& text) {
    const test::Run run = test::run(text);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    return ModelBuilder().build(run.evaluation.tree);
}

std::vector<CenterLine> lines_of(const std::string& text) {
    return center_lines(*model_of(text));
}

void expect_line(const CenterLine& line, glm::dvec3 from, glm::dvec3 to, double radius) {
    if (glm::distance(line.from, from) > glm::distance(line.from, to)) {
        std::swap(from, to);
    }
    EXPECT_LT(glm::distance(line.from, from), 1e-9);
    EXPECT_LT(glm::distance(line.to, to), 1e-9);
    EXPECT_NEAR(line.radius, radius, 1e-9);
}

TEST(CenterLines, GoAsFarAsTheLeafWithinItsPart) {
    const auto hole =
        lines_of("difference() { cube([20, 20, 6]); translate([5, 5, -50]) cylinder(r = 2, h = 100, $fn = 32); }");
    ASSERT_EQ(hole.size(), 1U);
    expect_line(hole[0], {5, 5, 0}, {5, 5, 6}, 2);
    const auto cone = lines_of("translate([1, 2, 3]) rotate([0, 90, 0]) cylinder(r1 = 4, r2 = 0, h = 10, $fn = 32);");
    ASSERT_EQ(cone.size(), 1U);
    expect_line(cone[0], {1, 2, 3}, {11, 2, 3}, 4);
}

TEST(CenterLines, OfOneAxisAreOne) {
    const auto lines = lines_of(
        "$fn = 24; cylinder(r = 5, h = 10); translate([0, 0, 10]) cylinder(r = 2, h = 30); translate([9, 0, 0]) "
        "cylinder(r = 1, h = 4);");
    ASSERT_EQ(lines.size(), 2U);
    expect_line(lines[0], {0, 0, 0}, {0, 0, 40}, 5);
    expect_line(lines[1], {9, 0, 0}, {9, 0, 4}, 1);
}

TEST(CenterLines, OfWhatIsTurnedAndExtruded) {
    const auto turned = lines_of("translate([0, 7, 0]) rotate_extrude($fn = 48) translate([3, 1]) square([2, 5]);");
    ASSERT_EQ(turned.size(), 1U);
    expect_line(turned[0], {0, 7, 1}, {0, 7, 6}, 5);
    const auto extruded =
        lines_of("linear_extrude(5) difference() { circle(8, $fn = 40); translate([4, 0]) circle(2, $fn = 20); }");
    EXPECT_EQ(extruded.size(), 2U);
    const auto sphere = lines_of("translate([1, 1, 1]) sphere(3, $fn = 20);");
    ASSERT_EQ(sphere.size(), 1U);
    expect_line(sphere[0], {1, 1, 1}, {1, 1, 1}, 3);
}

TEST(CenterLines, AreNoneOfCorners) {
    EXPECT_TRUE(lines_of("linear_extrude(5) offset(r = 2, $fn = 20) square(10);").empty());
    EXPECT_TRUE(
        lines_of("hull() { cylinder(r = 2, h = 3, $fn = 20); translate([9, 0, 0]) cylinder(r = 2, h = 3, $fn = 20); }")
            .empty());
    EXPECT_TRUE(lines_of("rotate_extrude(angle = 90, $fn = 48) translate([3, 1]) square([2, 5]);").empty());
    EXPECT_TRUE(lines_of("cylinder(r = 2, h = 3, $fn = 6);").empty());
    EXPECT_TRUE(lines_of("scale([1, 2, 1]) cylinder(r = 2, h = 3, $fn = 30);").empty());
}

/// Columns in which a white picture has ink, in the rows from `first` on.
std::vector<int> inked_columns(const base::Image& image, int first, int last) {
    std::vector<int> columns;
    for (int x = 0; x < image.width; ++x) {
        for (int y = first; y < last; ++y) {
            if (image.pixel(x, y)[0] < 200) {
                columns.push_back(x);
                break;
            }
        }
    }
    return columns;
}

TEST(CenterLines, AreChainsBeyondTheOutlineAndCrossesEndOn) {
    npr::Picture picture;
    picture.size = {400, 400};
    picture.camera.projection = base::Projection::Orthographic;
    picture.camera.distance = 200;
    const csg::Box box{{-20, -20, -20}, {20, 20, 20}};
    const auto drawn = [&](const glm::dvec3& rotation) {
        picture.camera.rotation = rotation;
        base::Image image{400, 400, std::vector<std::uint8_t>(4 * 400 * 400, 255)};
        draw_center_lines(image, {{{0, 0, -20}, {0, 0, 20}, 10}}, picture,
                          base::View(picture.camera, picture.size, box.lo, box.hi));
        return image;
    };
    const double pixel = 2 * base::View(picture.camera, picture.size, box.lo, box.hi).half_height() / 400;
    // From the right the axis is upright, and goes on by 2 mm of 96 dots an inch.
    const base::Image side = drawn({90, 0, 90});
    const std::vector<int> upright = inked_columns(side, 0, 400);
    ASSERT_FALSE(upright.empty());
    EXPECT_GE(upright.front(), 199);
    EXPECT_LE(upright.back(), 200);
    int first = 400, gaps = 0;
    bool before = false;
    for (int y = 0; y < 400; ++y) {
        const bool ink = std::min(side.pixel(199, y)[0], side.pixel(200, y)[0]) < 200;
        first = ink ? std::min(first, y) : first;
        gaps += before && !ink ? 1 : 0;
        before = ink;
    }
    EXPECT_NEAR(first, 200 - 20 / pixel - 2 * 96 / 25.4, 1.5);
    EXPECT_GE(gaps, 4) << "dashes and dots";
    // From above it is a point, with a cross.
    const base::Image top = drawn({0, 0, 0});
    const std::vector<int> cross = inked_columns(top, 198, 202);
    ASSERT_FALSE(cross.empty());
    EXPECT_NEAR(cross.front(), 200 - 10 / pixel - 2 * 96 / 25.4, 1.5);
    EXPECT_NEAR(cross.back(), 200 + 10 / pixel + 2 * 96 / 25.4, 1.5);
}

}  // namespace
}  // namespace ui
