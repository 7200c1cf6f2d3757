// Facets of smooth surfaces do not show where shading is smooth.
#include <cstdlib>

#include "tests/npr/easel.h"
#include "tests/support/gl_test.h"

namespace {

using scene::Model;

csg::Fineness fine(double segments) {
    csg::Fineness f;
    f.fn = segments;
    return f;
}

npr::Picture lit(const csg::Box& box, const char* smooth) {
    npr::Picture p = npr::default_picture();
    p.draw_as(*npr::find_style("edges"));
    p.camera = scene::camera(box);
    p.size = {160, 160};
    p.samples = 1;
    p.parameters.read("smooth-surfaces", smooth);
    p.parameters.read("inner", "0");
    return p;
}

/// The largest difference of two pictures but for the border of what is seen.
int largest_difference(const base::Image& a, const base::Image& b, const base::Image& outside) {
    const auto within = [&](int x, int y) {
        for (int j = -3; j <= 3; ++j) {
            for (int i = -3; i <= 3; ++i) {
                const int u = std::clamp(x + i, 0, a.width - 1), v = std::clamp(y + j, 0, a.height - 1);
                if (outside.pixel(u, v)[3] == 0) {
                    return false;
                }
            }
        }
        return true;
    };
    int worst = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            for (int c = 0; c < 3 && within(x, y); ++c) {
                worst = std::max(worst, std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]));
            }
        }
    }
    return worst;
}

/// By how much the picture of a model of 64 facets differs from that of one of `many`.
int facets_show(const std::function<Model(double)>& model, const char* smooth, double many = 720) {
    scene::Easel coarse(model(64)), true_one(model(many));
    npr::Picture p = lit(true_one.box(), smooth);
    p.transparent_background = true;
    const base::Image truth = true_one.paint(p);
    return largest_difference(coarse.paint(p), truth, truth);
}

TEST(SmoothShading, OfACylinderOf64StepsByNoMoreThanTwo) {
    const auto mantle = [](double n) {
        // Its caps are out of the picture.
        return scene::leaf(csg::Cylinder{20, 10, 10, true, fine(n)});
    };
    scene::Easel coarse(mantle(64)), true_one(mantle(720));
    npr::Picture p = lit(true_one.box(), "on");
    p.transparent_background = true;
    p.camera.rotation = {90, 0, 20};
    const base::Image truth = true_one.paint(p);
    EXPECT_LE(largest_difference(coarse.paint(p), truth, truth), 2);
    p.parameters.read("smooth-surfaces", "off");
    EXPECT_GE(largest_difference(coarse.paint(p), truth, truth), 6) << "facets show";
}

TEST(SmoothShading, OfConesAndSpheresAsOfFinerOnes) {
    const auto cone = [](double n) { return scene::leaf(csg::Cylinder{20, 10, 0, true, fine(n)}); };
    EXPECT_LE(facets_show(cone, "on"), 3) << "up to the tip";
    EXPECT_GE(facets_show(cone, "off"), 6);
    const auto sphere = [](double n) { return scene::leaf(csg::Sphere{10, fine(n)}); };
    EXPECT_LE(facets_show(sphere, "on", 192), 4);
    EXPECT_GE(facets_show(sphere, "off", 192), 6);
}

TEST(SmoothShading, LeavesFlatFacesAndOpenScadsPictureAsTheyAre) {
    scene::Easel boxes(scene::flush_blocks()), widget(scene::widget());
    EXPECT_EQ(scene::differing(boxes.paint(lit(boxes.box(), "on")), boxes.paint(lit(boxes.box(), "off")), 0), 0);
    npr::Picture plain = lit(widget.box(), "off");
    plain.draw_as(*plain.style);
    plain.parameters.read("inner", "0");
    EXPECT_EQ(scene::differing(widget.paint(lit(widget.box(), "off")), widget.paint(plain), 0), 0) << "the default";
    EXPECT_GT(scene::differing(widget.paint(lit(widget.box(), "on")), widget.paint(plain), 0), 1000);
}

class SmoothShadingTest : public test_support::GlTest {};

TEST_P(SmoothShadingTest, IsTheSameWithOpenGl) {
    scene::Easel easel(scene::widget());
    const npr::Picture p = lit(easel.box(), "on");
    EXPECT_LE(scene::differing(easel.paint(p), easel.draw(gl(), p), 1), 3);
}

INSTANTIATE_TEST_SUITE_P(Contexts, SmoothShadingTest, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

}  // namespace
