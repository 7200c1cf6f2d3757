// Lines of models given by their text: those that are there, and no others; and figures of the measure.
#include <gtest/gtest.h>

#include <string>

#include "csg/scad/scad.h"
#include "tests/bench/subject.h"
#include "tests/edges/edge_points.h"

namespace {

using edges::Kind;
using edges::Point;

std::shared_ptr<const ui::Model> model_of(const std::string& text) {
    csg::scad::Request request;
    request.path = "test.scad";
    request.text = text;
    const auto evaluation = csg::scad::evaluate(request, [](const csg::scad::Message&, const csg::scad::SourceSet&) {});
    return ui::ModelBuilder().build(evaluation.tree);
}

base::View view_of(const ui::Model& model, int size, const glm::dvec3& rotation = {55, 0, 25}) {
    base::Camera camera;
    camera.rotation = rotation;
    const csg::Box& box = model.geometry.box;
    base::view_all(camera, box.lo, box.hi, true);
    return {camera, glm::ivec2(size), box.lo, box.hi};
}

/// Points of creases that are found in all layers.
std::size_t creases(const std::string& text, const glm::dvec3& rotation = {55, 0, 25}) {
    const auto model = model_of(text);
    const base::View view = view_of(*model, 300, rotation);
    const auto found = edges::found_points(edges::layers_of(*model, view), view);
    return edges::only(found, [](const Point& p) { return p.kind != Kind::Silhouette; }).size();
}

edges::Score measure(const std::string& text, int size = 400) {
    const auto model = model_of(text);
    const base::View view = view_of(*model, size);
    return edges::score(edges::true_points(*model, ui::make_mesh(*model).mesh, view),
                        edges::found_points(edges::layers_of(*model, view), view), view.size());
}

TEST(Lines, NoneWithinSmoothSurfaces) {
    for (const char* n : {"8", "12", "48", "100"}) {
        const std::string fine = std::string("$fn = ") + n + "; ";
        EXPECT_EQ(creases(fine + "sphere(10);"), 0U) << n;
        EXPECT_EQ(creases(fine + "rotate_extrude() translate([10, 0]) circle(4);"), 0U) << n;
        EXPECT_EQ(creases(fine + "hull() { sphere(10); translate([20, 0, 0]) sphere(10); }"), 0U) << n;
    }
}

TEST(Lines, OfCylindersAreTheirRims) {
    for (const char* n : {"8", "12", "48", "100"}) {
        for (const char* shape : {"cylinder(r = 10, h = 20);", "cylinder(r1 = 10, r2 = 4, h = 20);",
                                  "linear_extrude(20) circle(10);", "linear_extrude(20, twist = 40) circle(10);"}) {
            const auto score = measure(std::string("$fn = ") + n + "; " + shape);
            EXPECT_GT(score.precision(), 0.99) << n << ' ' << shape;
            EXPECT_GT(score.recall(), 0.99) << n << ' ' << shape;
        }
    }
}

TEST(Lines, WhereFacesMeetAtSmallAngles) {
    // A chamfer of 5 degrees between two faces of an extrusion: two lines of the width of the picture, in front.
    const std::string chamfer =
        "rotate([90, 0, 0]) linear_extrude(20) polygon([[-20, 0], [20, 0], [20, 8], [2, 10], [-2, 10], [-20, 8.4]]);";
    EXPECT_GT(measure(chamfer).f(), 0.99);
    EXPECT_GT(creases(chamfer, {30, 0, 0}), 300U);
    // Two leaves that meet at 10 degrees, and one leaf less.
    const std::string leaves =
        "cube([20, 20, 10]); translate([0, 0, 10]) rotate([0, 10, 0]) translate([-20, 0, -10]) "
        "cube([20, 20, 10]);";
    EXPECT_GT(measure(leaves).f(), 0.99);
    EXPECT_GT(creases(leaves, {30, 0, 0}), creases("cube([20, 20, 10]);", {30, 0, 0}) + 100);
}

TEST(Lines, OfBoxesAndHexagonsAreThere) {
    EXPECT_GT(measure("cube(10);").f(), 0.999);
    EXPECT_GT(measure("cylinder(r = 10, h = 10, $fn = 6);").f(), 0.999);
    EXPECT_GT(creases("cylinder(r = 10, h = 10, $fn = 6);"), creases("cylinder(r = 10, h = 10, $fn = 60);") + 100);
}

TEST(Lines, SliversOfTwoTessellationsAreNone) {
    const std::string one = "cylinder(r = 6, h = 15, $fn = 48);";
    const std::string two =
        "cylinder(r = 6, h = 10, $fn = 48); rotate(3.75) translate([0, 0, 5]) cylinder(r = 6, h = 10, $fn = 48);";
    const std::size_t alone = creases(one);
    EXPECT_LE(creases(two), alone + alone / 15);
}

TEST(Lines, GoOnWhereSurfacesAreTangent) {
    // A slab between two cylinders.
    const std::string slot =
        "$fn = 48; cylinder(r = 5, h = 8); translate([20, 0, 0]) cylinder(r = 5, h = 8); "
        "translate([0, -5, 0]) cube([20, 10, 8]);";
    EXPECT_GT(measure(slot).precision(), 0.99);
    EXPECT_GT(measure(slot).recall(), 0.99);
}

TEST(Lines, GoOnWhereCylindersStandOnEachOther) {
    const std::string stack = "for (z = [0:4]) translate([0, 0, 2 * z]) cylinder(h = 2, r = 5, $fn = 36);";
    EXPECT_EQ(creases(stack), creases("cylinder(h = 10, r = 5, $fn = 36);"));
}

class Figures : public testing::TestWithParam<const char*> {};

TEST_P(Figures, StayAsGoodAsTheyAre) {
    const std::string path = std::string(CSGSCOPE_SOURCE_DIR) + "/" + GetParam();
    const bench::Subject subject = bench::from_file(path);
    const base::View view = view_of(*subject.model, 512);
    const auto visible = [](const Point& p) { return !p.hidden; };
    const auto stack = edges::layers_of(*subject.model, view);
    const auto truth =
        edges::only(edges::true_points(*subject.model, ui::make_mesh(*subject.model).mesh, view), visible);
    const auto score = edges::score(truth, edges::only(edges::found_points(stack, view), visible), view.size());
    EXPECT_GT(score.f(), 0.99);
    for (const edges::Buffer buffer : {edges::Buffer::Depth, edges::Buffer::Normal, edges::Buffer::Id}) {
        EXPECT_LT(edges::sobel_score(stack, view, buffer, truth).f(), score.f());
    }
}

INSTANTIATE_TEST_SUITE_P(, Figures,
                         testing::Values("models/spanner.scad", "models/pipe_tee.scad",
                                         "tests/edges/models/twisted_vase.scad",
                                         "tests/edges/models/involute_gear.scad", "tests/edges/models/thread.scad"));

}  // namespace
