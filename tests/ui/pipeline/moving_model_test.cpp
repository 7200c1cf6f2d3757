// Models from frame to frame: the same as those that are built anew, and cheaper.
#include "ui/pipeline/moving_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/csg/scad/evaluate_text.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {
namespace {

constexpr const char* kWheel =
    "translate([-30, -30, -8]) cube([60, 60, 2]); translate([20, 20, -6]) cylinder(h = 20, r = 3, $fn = 24);\n"
    "rotate(90 * $t) difference() { cylinder(h = 6, r = 14, $fn = 40); translate([8, 0, -1]) cylinder(h = 9, r = 3);"
    "cylinder(h = 20, r = 2, center = true); }";

std::shared_ptr<const csg::Tree> tree_of(const std::string& text, double time) {
    csg::scad::Request at;
    at.time = time;
    return test::run(text, {}, at).evaluation.tree;
}

PictureRequest blueprint() {
    npr::Picture picture = npr::default_picture();
    picture.draw_as(*npr::find_style("blueprint"));
    picture.size = {120, 120};
    picture.samples = 1;
    picture.camera.distance = 200;
    return PictureRequest(picture);
}

TEST(MovingModel, IsTheSameAsOneThatIsBuilt) {
    ModelBuilder builder;
    MovingModel moving(*builder.build(tree_of(kWheel, 0)), csg::Showing::Preview, {});
    Renderer kept({}, Painter::Cpu);
    (void)kept.render(moving.model(), blueprint());
    for (const double time : {0.1, 0.5, 0.7}) {
        const auto tree = tree_of(kWheel, time);
        ASSERT_TRUE(moving.follow(*tree)) << time;
        // The wheel, its hole and its bore; the bore turns about its own axis.
        EXPECT_EQ(moving.moved(), 3u);
        kept.update(moving.model(), moving.change());
        ModelBuilder anew;
        const auto built = anew.build(tree);
        Renderer fresh({}, Painter::Cpu);
        EXPECT_EQ(kept.render(moving.model(), blueprint()).rgba, fresh.render(*built, blueprint()).rgba) << time;
    }
}

TEST(MovingModel, SaysWhereItIsAnother) {
    ModelBuilder builder;
    const auto model = builder.build(tree_of(kWheel, 0));
    const auto follows = [&](const std::string& text, double time) {
        MovingModel moving(*model, csg::Showing::Preview, {});
        return moving.follow(*tree_of(text, time));
    };
    EXPECT_TRUE(follows(kWheel, 0.3));
    EXPECT_FALSE(follows(std::string(kWheel) + "cube(1);", 0)) << "one more leaf";
    EXPECT_FALSE(follows(std::string("color(\"red\") {") + kWheel + "}", 0)) << "another color";
    std::string larger = kWheel;
    larger.replace(larger.find("r = 14"), 6, "r = 15");
    EXPECT_FALSE(follows(larger, 0)) << "another shape";
    EXPECT_FALSE(follows(std::string("translate([0, 0, 9 * $t]) {") + kWheel + "}", 1)) << "other bounds";
    EXPECT_TRUE(same_content(*tree_of(kWheel, 0), *tree_of(std::string("\n") + kWheel, 0)));
    EXPECT_FALSE(same_content(*tree_of(kWheel, 0), *tree_of(kWheel, 0.5)));
}

/// Strokes do not crawl: from frame to frame of a turntable in steps of half a degree the ink changes by less than 2 %.
TEST(MovingModel, InkIsSteadyWhileTheCameraTurns) {
    csg::scad::Request request;
    request.path = CSGSCOPE_SOURCE_DIR "/models/gears.scad";
    ModelBuilder builder;
    const auto model = builder.build(csg::scad::evaluate(request, {}).tree);
    for (const bool dashes : {false, true}) {
        PictureRequest picture = blueprint();
        picture.parameters.read("dashes", dashes ? "1" : "0");
        picture.samples = 4;
        picture.size = {256, 256};
        picture.camera = {};
        base::view_all(picture.camera, model->box.lo, model->box.hi, true);
        Renderer renderer({}, Painter::Cpu);
        double before = 0, most = 0;
        for (int frame = 0; frame < 6; ++frame) {
            picture.camera.rotation.z = 25 + 0.5 * frame;
            const base::Image image = renderer.render(*model, picture);
            double ink = 0;
            for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
                ink += std::max(0, int{image.rgba[i]} - int{image.rgba[0]});
            }
            most = std::max(most, frame == 0 ? 0 : std::abs(ink - before) / before);
            before = ink;
        }
        EXPECT_GT(most, 0);
        EXPECT_LT(most, 0.02) << dashes;
    }
}

}  // namespace
}  // namespace ui
