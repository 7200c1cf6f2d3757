// Lines are as wide as was asked for, in the views of drawings, too, where faces are seen edge-on.
#include "tests/edges/line_widths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "csg/scad/scad.h"
#include "npr/samples.h"

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
            const auto widths =
                edges::line_widths(edges::layers_of(*model, view), view, edges::true_points(*model, mesh, view),
                                   edges::black_on_paper(kWidth));
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

/// Mean of the ink along hidden silhouettes, and its standard deviation as a share of that.
struct Ink {
    double mean = 0, variation = 0;
    std::size_t points = 0;
};

Ink hidden_ink(const char* text, const base::Camera& from, const edges::Drawing& drawing) {
    const auto model = model_of(text);
    const csg::Box& box = model->geometry.box;
    base::Camera camera = from;
    base::view_all(camera, box.lo, box.hi, true);
    const glm::ivec2 size(320);
    const auto truth = edges::true_points(*model, ui::make_mesh(*model).mesh, base::View(camera, size, box.lo, box.hi));
    std::vector<double> ink;
    const auto samples = npr::sample_offsets(4);
    for (const glm::dvec2& jitter : samples) {
        const base::View view(camera, size, box.lo, box.hi, jitter);
        auto widths = edges::line_widths(edges::layers_of(*model, view), view, truth, drawing, true);
        std::erase_if(widths, [](const edges::Width& w) { return w.kind != edges::Kind::Silhouette; });
        ink.resize(widths.size());
        std::transform(widths.begin(), widths.end(), ink.begin(), ink.begin(), [&](const edges::Width& w, double sum) {
            return sum + w.ink / static_cast<double>(samples.size());
        });
    }
    Ink result{0, 0, ink.size()};
    for (const double i : ink) {
        result.mean += i / static_cast<double>(ink.size());
    }
    for (const double i : ink) {
        result.variation += (i - result.mean) * (i - result.mean) / static_cast<double>(ink.size());
    }
    result.variation = std::sqrt(result.variation) / result.mean;
    return result;
}

TEST(HiddenLines, HaveTheSameInkAllAlong) {
    const edges::Drawing drawing{
        "blueprint",
        {{"tone", "0"}, {"ground", "white"}, {"width", "1"}, {"hidden-width", "1"}, {"hidden", "1"}, {"falloff", "1"}},
        0xf6 / 255.0,
        0x1b / 255.0};
    base::Camera front;
    front.rotation = {90, 0, 0};
    base::Camera flat = front;
    flat.projection = base::Projection::Orthographic;
    base::Camera oblique;
    oblique.rotation = {80, 0, 12};
    for (const char* text : {"$fn = 200; sphere(10); translate([-15, -25, -15]) cube([30, 5, 30]);",
                             "difference() { cube(30, center = true); sphere(10, $fn = 30); }"}) {
        for (const base::Camera& camera : {front, flat, oblique}) {
            const Ink ink = hidden_ink(text, camera, drawing);
            EXPECT_GT(ink.points, 300U) << text;
            EXPECT_NEAR(ink.mean, 1, 0.1) << text;
            EXPECT_LT(ink.variation, 0.05) << text;
        }
    }
}

TEST(HiddenLines, StandOutFromEitherGround) {
    const auto model = model_of("cube([20, 14, 9]);");
    const csg::Box& box = model->geometry.box;
    base::Camera camera;
    base::view_all(camera, box.lo, box.hi, true);
    const base::View view(camera, glm::ivec2(200), box.lo, box.hi);
    const auto stack = edges::layers_of(*model, view);
    const auto truth = edges::true_points(*model, ui::make_mesh(*model).mesh, view);
    for (const char* ground : {"blue", "white"}) {
        for (const auto& [strength, contrast] : {std::pair{"", 3.0}, {"0.9", 5.0}}) {
            edges::Drawing drawing{"blueprint", {{"ground", ground}, {"width", "4"}}};
            if (*strength != 0) {
                drawing.settings["hidden"] = strength;
            }
            const auto light = edges::painted(stack, view, drawing);
            const auto luminance = [&](const glm::dvec2& at) {
                const glm::vec4& c = light[static_cast<std::size_t>(at.y) * 200 + static_cast<std::size_t>(at.x)];
                return glm::dot(glm::dvec3(c), glm::dvec3(0.2126, 0.7152, 0.0722));
            };
            int points = 0, clear = 0;
            for (const edges::Point& p : truth) {
                const auto near = [&](const edges::Point& q) { return !q.hidden && glm::distance(p.at, q.at) < 12; };
                if (!p.hidden || std::any_of(truth.begin(), truth.end(), near)) {
                    continue;
                }
                const auto contrast_to = [&](const glm::dvec2& away) {
                    const double line = luminance(p.at) + 0.05, beside = luminance(p.at + away) + 0.05;
                    return std::max(line, beside) / std::min(line, beside);
                };
                ++points;
                clear += std::max(contrast_to({6, 6}), contrast_to({-6, 6})) >= contrast ? 1 : 0;
            }
            EXPECT_GT(points, 60) << ground;
            EXPECT_GT(clear, 0.95 * points) << ground << ' ' << strength;
        }
    }
}

/// The darkness of a picture with four samples: blue, sRGB.
std::vector<double> darkness(const char* text, base::Camera camera, glm::ivec2 size,
                             const std::map<std::string, std::string>& settings, double dots_per_inch = 0) {
    const auto model = model_of(text);
    const csg::Box& box = model->geometry.box;
    std::vector<double> sum(static_cast<std::size_t>(size.x * size.y), 0.0);
    const auto samples = npr::sample_offsets(4);
    for (const glm::dvec2& jitter : samples) {
        const base::View view(camera, size, box.lo, box.hi, jitter);
        const auto light = edges::painted(edges::layers_of(*model, view), view, {"edges", settings}, dots_per_inch);
        std::transform(sum.begin(), sum.end(), light.begin(), sum.begin(), [&](double s, const glm::vec4& c) {
            return s + (1 - static_cast<double>(c.x)) / static_cast<double>(samples.size());
        });
    }
    return sum;
}

base::Camera flat_camera(double height) {
    base::Camera camera;
    camera.rotation = {0, 0, 0};
    camera.projection = base::Projection::Orthographic;
    camera.distance = height / 2 / std::tan(camera.fov * M_PI / 360);
    return camera;
}

TEST(Wires, NeitherBreakUpNorTurnBlack) {
    // As many units high as pixels. Surfaces are white, lines black.
    const glm::ivec2 size(120, 60);
    for (const double thickness : {0.3, 0.5, 1.0, 1.5, 2.0, 3.0}) {
        const std::string text =
            fmt::format("rotate([0, 90, 7]) cylinder(d = {}, h = 140, center = true, $fn = 16);", thickness);
        const auto dark = darkness(text.c_str(), flat_camera(60), size, {{"shade", "0"}, {"edge-color", "#000000"}});
        double least = 1e9, most = 0, sum = 0, darkest = 0;
        for (int x = 10; x + 4 < size.x - 10; ++x) {
            // What a wire is made of where it goes down a pixel is seen over some columns.
            double ink = 0;
            for (int i = 0; i < 4 * size.y; ++i) {
                const double d = dark[static_cast<std::size_t>(i / 4 * size.x + x + i % 4)];
                ink += d / 4;
                darkest = std::max(darkest, d);
            }
            least = std::min(least, ink);
            most = std::max(most, ink);
            sum += ink;
        }
        EXPECT_GT(least, 0.7 * most) << thickness;
        EXPECT_GT(least, 0.7) << thickness;
        EXPECT_LT(darkest, thickness < 2.5 ? 0.95 : 1) << thickness;
    }
}

TEST(Widths, InMillimetersGiveTheSameDrawingAtAnySize) {
    const char* const text =
        "$fn = 64; difference() { cylinder(r = 40, h = 8); cylinder(r = 25, h = 20, center = true); }";
    const auto drawn = [&](int side) {
        const auto dark = darkness(text, flat_camera(100), glm::ivec2(side),
                                   {{"shade", "0"}, {"edge-color", "#000000"}, {"width", "2.4mm"}}, side * 25.4 / 100);
        // Ink by 32nds of the picture.
        std::vector<double> cells(32 * 32, 0.0);
        const int cell = side / 32;
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                cells[static_cast<std::size_t>(y / cell * 32 + x / cell)] +=
                    dark[static_cast<std::size_t>(y * side + x)] / (cell * cell);
            }
        }
        return cells;
    };
    const auto small = drawn(256), large = drawn(1024);
    double sum = 0, other = 0, apart = 0;
    for (std::size_t i = 0; i < small.size(); ++i) {
        sum += large[i];
        other += small[i];
        apart += std::abs(small[i] - large[i]);
    }
    EXPECT_NEAR(other / sum, 1, 0.06);
    EXPECT_LT(apart / sum, 0.07);
}

INSTANTIATE_TEST_SUITE_P(, LineWidths, testing::ValuesIn(kCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
