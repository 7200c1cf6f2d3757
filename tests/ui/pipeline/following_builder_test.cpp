// A program while it is edited: the models are those that are built anew, and an edit that moves something is cheap.
#include "ui/pipeline/following_builder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <fmt/format.h>

#include "tests/csg/scad/evaluate_text.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {
namespace {

std::string plate(double x, double y, const char* more = "") {
    return fmt::format(
        "difference() {{ cube([60, 40, 4]); for (i = [0 : 5], j = [0 : 3]) translate([10 * i + 5, 10 * "
        "j + 5, -1]) cylinder(h = 6, r = 3, $fn = 16); }}\ntranslate([{}, {}, 1]) color(\"red\") "
        "cube(5);\n{}",
        x, y, more);
}

std::shared_ptr<const csg::Tree> tree_of(const std::string& text) {
    return test::run(text).evaluation.tree;
}

std::vector<std::uint8_t> picture_of(const Model& model) {
    npr::Picture picture = npr::default_picture();
    picture.draw_as(*npr::find_style("blueprint"));
    picture.size = {120, 90};
    picture.samples = 1;
    picture.camera.distance = 200;
    return Renderer({}, Painter::Cpu).render(model, PictureRequest(picture)).rgba;
}

TEST(FollowingBuilder, MakesWhatIsBuilt) {
    FollowingBuilder builder;
    const auto check = [&](const std::string& text, bool follows) {
        SCOPED_TRACE(text);
        const auto tree = tree_of(text);
        const auto model = builder.build(tree);
        EXPECT_EQ(builder.followed(), follows);
        const auto built = ModelBuilder().build(tree);
        EXPECT_EQ(model->tree, tree);
        EXPECT_EQ(model->box, built->box);
        EXPECT_EQ(model->geometry.box, built->geometry.box);
        EXPECT_EQ(model->scene.leaves.size(), built->scene.leaves.size());
        EXPECT_EQ(model->scene.occurrences.size(), built->scene.occurrences.size());
        EXPECT_EQ(model->statistics.leaves, built->statistics.leaves);
        EXPECT_EQ(model->statistics.triangles, built->statistics.triangles);
        for (std::size_t i = 0; i < std::min(model->geometry.leaves.size(), built->geometry.leaves.size()); ++i) {
            EXPECT_EQ(model->geometry.leaves[i].points, built->geometry.leaves[i].points) << i;
        }
        EXPECT_EQ(picture_of(*model), picture_of(*built));
        return model->generation;
    };
    const auto first = check(plate(20, 10), false);
    const auto second = check(plate(22, 10), true);
    EXPECT_NE(first, second);
    check("// A comment: everything stands elsewhere in the text.\n" + plate(22, 12.5), true);
    check(plate(20, 10), true);                                        // Undone.
    check(plate(20, 10, "translate([30, 10, 2]) sphere(3);"), false);  // One more.
    check(plate(20, 10, "translate([31, 12, 2]) sphere(3);"), true);   //
    check(plate(90, 10, "translate([31, 12, 2]) sphere(3);"), false);  // The bounds are others.
    check(plate(20, 10, "translate([31, 12, 2]) sphere(2);"), false);  // Another shape.
    check("translate([0, 0, 1]) {" + plate(20, 10) + "}", false);      // All of it has moved.
}

TEST(FollowingBuilder, BeginsAnewWithOtherSettings) {
    FollowingBuilder builder;
    (void)builder.build(tree_of(plate(20, 10)));
    csg::PartRule by_colors;
    by_colors.kind = csg::PartRule::Kind::Color;
    builder.divide(by_colors);
    const auto by_color = builder.build(tree_of(plate(21, 10)));
    EXPECT_FALSE(builder.followed());
    EXPECT_GT(by_color->scene.parts.size(), 1U);
    builder.show(csg::Showing::Result);
    (void)builder.build(tree_of(plate(22, 10)));
    EXPECT_FALSE(builder.followed());
    npr::Sections sections;
    sections.cuts.emplace_back();
    builder.cut(sections);
    (void)builder.build(tree_of(plate(23, 10)));
    EXPECT_FALSE(builder.followed());
}

}  // namespace
}  // namespace ui
