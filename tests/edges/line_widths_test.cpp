// Lines are as wide as was asked for, in the views of drawings, too, where faces are seen edge-on.
#include "tests/edges/line_widths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "csg/scad/scad.h"

namespace {

struct Case {
    const char* name;
    const char* text;
};

constexpr Case kCases[] = {
    {"cylinder", "$fn = 64; cylinder(r = 10, h = 20);"},
    {"ring", "$fn = 64; difference() { cylinder(r = 10, h = 8); translate([0, 0, -1]) cylinder(r = 6, h = 10); }"},
    {"box", "cube([20, 14, 9]);"},
    {"cone", "$fn = 64; cylinder(r1 = 10, r2 = 4, h = 20);"},
    {"tee", "include <models/pipe_tee.scad>"},
};

constexpr glm::dvec3 kViews[] = {{90, 0, 0}, {90, 0, 180}, {0, 0, 0}, {180, 0, 0}, {90, 0, 90}, {90, 0, 270}};

std::shared_ptr<const ui::Model> model_of(const char* text) {
    csg::scad::Request request;
    request.path = std::string(CSGSCOPE_SOURCE_DIR) + "/test.scad";
    request.text = text;
    const auto evaluation = csg::scad::evaluate(request, [](const csg::scad::Message&, const csg::scad::SourceSet&) {});
    return ui::ModelBuilder().build(evaluation.tree);
}

class LineWidths : public testing::TestWithParam<Case> {};

TEST_P(LineWidths, InTheViewsOfDrawings) {
    constexpr double kWidth = 1.25;
    const auto model = model_of(GetParam().text);
    const auto mesh = ui::make_mesh(*model).mesh;
    const csg::Box& box = model->geometry.box;
    for (const double turned : {0.0, 0.01}) {
        for (const glm::dvec3& rotation : kViews) {
            base::Camera camera;
            camera.projection = base::Projection::Orthographic;
            camera.rotation = rotation + turned;
            base::view_all(camera, box.lo, box.hi, true);
            const base::View view(camera, glm::ivec2(320), box.lo, box.hi);
            const auto widths = edges::line_widths(edges::layers_of(*model, view), view,
                                                   edges::true_points(*model, mesh, view), kWidth);
            ASSERT_GT(widths.size(), 1000U);
            double sum = 0, off = 0;
            for (const edges::Width& w : widths) {
                sum += w.ink;
                off += std::abs(w.ink - kWidth) > 0.1 * kWidth ? 1 : 0;
                EXPECT_GT(w.ink, 0.9 * kWidth) << w.at.x << ", " << w.at.y;
                EXPECT_LT(w.ink, 1.6 * kWidth) << w.at.x << ", " << w.at.y;
            }
            const auto count = static_cast<double>(widths.size());
            const std::string where = fmt::format("{}, {}, {} turned by {}: mean {:.3f}, {:.1f}% off", rotation.x,
                                                  rotation.y, rotation.z, turned, sum / count, 100 * off / count);
            EXPECT_NEAR(sum / count, kWidth, 0.04 * kWidth) << where;
            EXPECT_LT(off / count, 0.1) << where;
            RecordProperty(GetParam().name, where);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(, LineWidths, testing::ValuesIn(kCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
