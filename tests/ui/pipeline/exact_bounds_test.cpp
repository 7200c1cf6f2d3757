#include "ui/pipeline/picture/exact_bounds.h"

#include <gtest/gtest.h>

#include "tests/csg/scad/evaluate_text.h"
#include "ui/pipeline/mesh/mesh.h"

namespace ui {
namespace {

std::shared_ptr<const Model> result_of(const std::string& text) {
    const test::Run run = test::run(text);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    ModelBuilder builder;
    builder.show(csg::Showing::Result);
    return builder.build(run.evaluation.tree);
}

void expect_near(const csg::Box& box, const csg::Box& expected, double tolerance) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.lo[axis], expected.lo[axis], tolerance) << "axis " << axis;
        EXPECT_NEAR(box.hi[axis], expected.hi[axis], tolerance) << "axis " << axis;
    }
}

TEST(ExactBounds, AreThoseOfWhatIsLeft) {
    const auto model = result_of("difference() { cube(20); translate([-1, -1, 5]) cube(30); }");
    EXPECT_EQ(exact_bounds(*model), (csg::Box{{0, 0, 0}, {20, 20, 5}}));
    EXPECT_EQ(model->box, (csg::Box{{0, 0, 0}, {20, 20, 20}})) << "that of the product";
}

TEST(ExactBounds, LeaveOutWhatIsNoResult) {
    EXPECT_EQ(exact_bounds(*result_of("cube(1); %cube(9); difference() { cube(2); #cube([9, 9, 1]); }")),
              (csg::Box{{0, 0, 0}, {2, 2, 2}}));
    EXPECT_TRUE(exact_bounds(*result_of("%cube(9);")).empty());
    EXPECT_TRUE(exact_bounds(*result_of("difference() { cube(1); cube(3, center = true); }")).empty());
}

TEST(ExactBounds, OfOutlinesAreFlat) {
    EXPECT_EQ(exact_bounds(*result_of("difference() { square([4, 3]); translate([2, -1]) square(9); }")),
              (csg::Box{{0, 0, 0}, {2, 3, 0}}));
}

/// Against the exact mesh: tips, edges and curved walls, at each side.
TEST(ExactBounds, EqualThoseOfTheMesh) {
    for (const char* text :
         {"linear_extrude(30, scale = [1 / 20, 20]) scale([1, 0.1]) rotate(45) square(10, center = true);"
          "translate([-40, 0, 0]) cube(5);",
          "intersection() { sphere(9, $fn = 40); rotate([20, 30, 40]) cube(14, center = true); }",
          "rotate([31, 17, 5]) difference() { cylinder(h = 40, r1 = 3, r2 = 0, $fn = 7); cube(9, center = true); }",
          "difference() { cube(10, center = true); for (a = [0:60:300]) rotate([a, 2 * a, 3 * a]) translate([3, 0, 0])"
          " cube(9); }"}) {
        SCOPED_TRACE(text);
        const auto model = result_of(text);
        const csg::Box expected = make_mesh(*model).facts.box;
        expect_near(exact_bounds(*model), expected, 1e-5 * expected.diagonal());
    }
}

}  // namespace
}  // namespace ui
