// Maps of thickness: values at places of known size, of both painters, through sections, and what is not measured.
#include "ui/pipeline/picture/thickness_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

#include "npr/srgb.h"
#include "npr/style.h"
#include "tests/csg/scad/evaluate_text.h"
#include "tests/support/gl_test.h"
#include "ui/pipeline/sections.h"

namespace ui {
namespace {

constexpr const char* kTray =
    "difference() { cube([40, 30, 12]); translate([3, 2, 5]) cube([20, 26, 20]); translate([24, 2, 5]) cube([10, 26, "
    "20]); }";

std::shared_ptr<const Model> model_of(const std::string& text) {
    const test::Run run = test::run(text);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    return ModelBuilder().build(run.evaluation.tree);
}

/// Straight from above, a pixel for each 0.25 units.
PictureRequest from_above() {
    PictureRequest picture;
    picture.size = {240, 240};
    picture.samples = 1;
    picture.camera.projection = base::Projection::Orthographic;
    picture.camera.rotation = glm::dvec3(0);
    picture.camera.target = {20, 15, 0};
    picture.camera.distance = 30 / std::tan(glm::radians(0.5 * picture.camera.fov));
    return picture;
}

ThicknessMap map_of(const Model& model, const PictureRequest& picture, const ThicknessRequest& request) {
    Renderer renderer({}, Painter::Cpu);
    return thickness_map(renderer, model, model, picture, request);
}

glm::vec3 tint_at(const ThicknessMap& map, double x, double y) {
    const int column = static_cast<int>(120 + (x - 20) * 4), row = static_cast<int>(120 - (y - 15) * 4);
    return map.tint[static_cast<std::size_t>(row * 240 + column)];
}

glm::vec3 tone(double value, double range) {
    const glm::vec3 srgb = thickness_tone(static_cast<float>(value / range));
    const npr::SrgbTables& tables = npr::SrgbTables::get();
    return {tables.linear(srgb.r), tables.linear(srgb.g), tables.linear(srgb.b)};
}

TEST(Thickness, WallsAreThoseOfTheSolid) {
    const auto model = model_of(kTray);
    const ThicknessMap map = map_of(*model, from_above(), {ThicknessRequest::What::Wall, false, 20});
    EXPECT_EQ(map.range, 20);
    EXPECT_EQ(tint_at(map, 10, 15), tone(5, 20));
    EXPECT_EQ(tint_at(map, 23.5, 15), tone(12, 20));
    EXPECT_EQ(tint_at(map, -5, 15), glm::vec3(1));
    ASSERT_FALSE(map.places.empty());
    EXPECT_NEAR(map.places[0].value, 5, 1e-6);
}

TEST(Thickness, GapsAreThoseBetweenSolids) {
    const auto model = model_of(fmt::format("{}translate([10, 10, 5.5]) cube([4, 4, 3]);", kTray));
    PictureRequest picture = from_above();
    picture.camera.rotation = {40, 0, 0};
    const ThicknessMap map = map_of(*model, picture, {ThicknessRequest::What::Gap, false, {}});
    ASSERT_FALSE(map.places.empty());
    EXPECT_NEAR(map.places[0].value, 0.5, 1e-6);  // Below the box, as far as one sees in there.
}

TEST(Thickness, AlongTheViewItIsWhatTheRayGoesThrough) {
    const auto model = model_of("cube(10);");
    PictureRequest picture = from_above();
    picture.camera.rotation = {60, 0, 0};  // Looks down by 30 degrees, onto the middle of the top.
    picture.camera.target = {5, 5, 10};
    const ThicknessMap map = map_of(*model, picture, {ThicknessRequest::What::Wall, true, 40});
    EXPECT_NEAR(glm::length(map.tint[120 * 240 + 120] - tone(5 / std::cos(glm::radians(30.0)), 40)), 0, 0.05);
    const ThicknessMap down = map_of(*model, from_above(), {ThicknessRequest::What::Wall, true, 20});
    EXPECT_EQ(tint_at(down, 5, 5), tone(10, 20));
}

class ThicknessByPainters : public test_support::GlTest {};

TEST_P(ThicknessByPainters, IsTheSameButAlongEdges) {
    const auto model = model_of(kTray);
    PictureRequest picture = from_above();
    picture.camera.rotation = {50, 0, 20};
    const ThicknessRequest request{ThicknessRequest::What::Wall, false, 20};
    Renderer renderer(*context_, {}, Painter::OpenGl);
    const ThicknessMap drawn = thickness_map(renderer, *model, *model, picture, request),
                       painted = map_of(*model, picture, request);
    std::size_t different = 0;
    for (std::size_t i = 0; i < drawn.tint.size(); ++i) {
        different += glm::length(drawn.tint[i] - painted.tint[i]) > 1e-3F ? 1 : 0;
    }
    EXPECT_LT(different, drawn.tint.size() / 200);
}

INSTANTIATE_TEST_SUITE_P(All, ThicknessByPainters, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

TEST(Thickness, FacesOfSectionsAreNotMeasured) {
    const auto model = model_of(kTray);
    const npr::Sections sections{{{npr::PlaneSection{{0, 0, 1}, 8, npr::PlaneSection::Away::Beyond}, "z>8"}}, {}, 0};
    SectionedModel sectioned;
    const Model& cut = sectioned.cut(model, sections);
    Renderer renderer({}, Painter::Cpu);
    const ThicknessMap map =
        thickness_map(renderer, *model, cut, from_above(), {ThicknessRequest::What::Wall, false, 20});
    EXPECT_EQ(tint_at(map, 10, 15), tone(5, 20));
    EXPECT_EQ(tint_at(map, 37, 15), glm::vec3(0.62F));
}

TEST(Thickness, SharpEdgesAreNoThinPlaces) {
    const auto model = model_of("rotate([90, 0, 0]) linear_extrude(20) polygon([[0, 0], [20, 0], [0, 12.1]]);");
    PictureRequest picture = from_above();
    const ThicknessMap map = map_of(*model, picture, {ThicknessRequest::What::Wall, false, {}});
    for (const ThinPlace& place : map.places) {
        EXPECT_GT(place.value, 1);
    }
}

TEST(Thickness, PicturesWithoutColorsKeepOpacities) {
    const auto model = model_of("color(\"red\", 0.5) cube(10); color(\"blue\") translate([20, 0, 0]) cube(5);");
    const auto plain = without_colors(*model);
    ASSERT_EQ(plain->scene.leaves.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_FALSE(plain->scene.leaves[i].color.given());
        EXPECT_EQ(plain->scene.leaves[i].color.a, model->scene.leaves[i].color.a);
    }
    EXPECT_NE(plain->generation, model->generation);
}

}  // namespace
}  // namespace ui
