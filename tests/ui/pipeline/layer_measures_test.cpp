// Measures from layers: closed forms, the exact mesh, and errors that shrink with the precision that is asked for.
#include "ui/pipeline/inspection/layer_measures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/csg/scad/evaluate_text.h"
#include "ui/pipeline/mesh/mesh.h"

namespace ui {
namespace {

std::shared_ptr<const Model> model_of(const std::string& text, bool parts = false) {
    const test::Run run = test::run(text);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    ModelBuilder builder;
    builder.show(csg::Showing::Result);
    if (parts) {
        builder.divide({csg::PartRule::Kind::Depth, 1, {}});
    }
    return builder.build(run.evaluation.tree);
}

/// Volume, area, first and second moments about the origin, of a closed mesh.
struct MeshMoments {
    double volume = 0, area = 0;
    glm::dvec3 first{0.0};
};

MeshMoments moments_of(const csg::reference::Mesh& mesh) {
    MeshMoments result;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
        const double volume = glm::dot(a, glm::cross(b, c)) / 6;
        result.volume += volume;
        result.first += volume * (a + b + c) / 4.0;
        result.area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return result;
}

TEST(LayerMeasures, ABoxInClosedForm) {
    const auto model = model_of("translate([100, 5, 7]) rotate([0, 0, 30]) cube([40, 30, 12]);");
    const SolidMeasures all = measure_by_layers(*model, 0.02).all;
    EXPECT_NEAR(all.volume.value, 14400, 0.002 * 14400);
    EXPECT_NEAR(all.area.value, 4080, 0.004 * 4080);
    const double c = std::cos(glm::radians(30.0)), s = std::sin(glm::radians(30.0));
    EXPECT_NEAR(all.centroid.x, 100 + 20 * c - 15 * s, 0.05);
    EXPECT_NEAR(all.centroid.y, 5 + 20 * s + 15 * c, 0.05);
    EXPECT_NEAR(all.centroid.z, 13, 0.01);
    const glm::dvec3 exact = 14400 / 12.0 * glm::dvec3(900 + 144, 1600 + 144, 1600 + 900);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(all.moments[i], exact[i], 0.005 * exact[i]);
    }
}

TEST(LayerMeasures, ErrorsBoundWhatTheExactMeshSays) {
    for (const char* const text : {"difference() { cube([40, 30, 12]); translate([3, 2, 5]) cube([20, 26, 20]); "
                                   "translate([30, 15, -1]) cylinder(d "
                                   "= 7, h = 20, $fn = 40); }",
                                   "rotate([20, 35, 10]) difference() { sphere(10, $fn = 48); cylinder(r = 4, h = 30, "
                                   "center = true, $fn = 30); }",
                                   "intersection() { cube(10, center = true); sphere(6.5, $fn = 40); }",
                                   "cube(10); translate([5, 5, 5]) cube(10);"}) {
        const auto model = model_of(text);
        const MeshMoments mesh = moments_of(make_mesh(*model).mesh);
        double error = mesh.volume;
        for (const double precision : {0.05, 0.015}) {
            const SolidMeasures all = measure_by_layers(*model, precision).all;
            EXPECT_NEAR(all.volume.value, mesh.volume, all.volume.error + 1e-9 * mesh.volume) << text;
            EXPECT_NEAR(all.area.value, mesh.area, all.area.error + 1e-9 * mesh.area) << text;
            EXPECT_LE(glm::length(all.centroid - mesh.first / mesh.volume), all.centroid_error + 1e-9) << text;
            EXPECT_LE(all.volume.error, precision * all.volume.value) << text;
            EXPECT_LE(all.volume.error, error);
            error = all.volume.error;
        }
    }
}

TEST(LayerMeasures, PartsByThemselvesAndAllOnce) {
    const auto model =
        model_of("cube(10); translate([5, 0, 0]) cube(10); translate([15, 0, 0]) cube([10, 10, 10]);", true);
    ASSERT_EQ(model->scene.parts.size(), 3u);
    const LayerMeasures measures = measure_by_layers(*model, 0.02);
    for (const SolidMeasures& part : measures.parts) {
        EXPECT_NEAR(part.volume.value, 1000, part.volume.error);
        EXPECT_NEAR(part.area.value, 600, part.area.error);
    }
    EXPECT_NEAR(measures.all.volume.value, 2500, measures.all.volume.error);
    EXPECT_NEAR(measures.all.area.value, 200 + 4 * 250, measures.all.area.error);  // Nothing of what touches.
}

}  // namespace
}  // namespace ui
