// Hatching and stippling: as much ink as the tone asks for, and strokes and dots that stay on the model.
#include <fmt/format.h>

#include <cmath>

#include "tests/npr/easel.h"
#include "tests/support/gl_test.h"

namespace {

npr::Picture picture(std::string_view style, float darkest, const base::Camera& camera) {
    npr::Picture p;
    p.draw_as(*npr::find_style(style));
    p.parameters.set("tone", darkest);
    p.parameters.set("ink", glm::vec3(0));
    p.scheme = npr::color_schemes().front();
    p.camera = camera;
    p.size = {160, 160};
    p.samples = 1;
    return p;
}

/// Of ink, 0 to 1, where it is black on white and nothing else is in the picture.
double coverage(const base::Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        sum += image.rgba[i];
    }
    return 1 - sum / (255.0 * static_cast<double>(image.rgba.size()) / 4);
}

base::Camera close_up(double turn, double tilt, double distance, base::Projection projection) {
    base::Camera camera;
    camera.projection = projection;
    camera.target = {50, 50, 10};
    camera.rotation = {tilt, 0, turn};
    camera.distance = distance;
    return camera;
}

TEST(AnchoredInk, IsAsMuchAsTheToneAsksFor) {
    scene::Easel easel(scene::box({-400, -400, 0}, {900, 900, 10}));
    for (const char* style : {"hatch", "stipple"}) {
        for (const float darkest : {0.15F, 0.4F, 0.65F, 0.95F}) {
            for (const auto& [turn, tilt, distance] :
                 {std::tuple(0.0, 0.0, 60.0), {20.0, 35.0, 83.0}, {130.0, 50.0, 117.0}, {250.0, 20.0, 160.0}}) {
                const npr::Picture p =
                    picture(style, darkest, close_up(turn, tilt, distance, base::Projection::Orthographic));
                const base::View view(p.camera, p.size, easel.box().lo, easel.box().hi);
                const glm::dvec3 normal(view.eye_from_world() * glm::dvec4(0, 0, 1, 0));
                const double direct = std::max(glm::dot(normal, glm::dvec3(-1, 1, 1)) / std::sqrt(3.0), 0.0);
                EXPECT_NEAR(coverage(easel.paint(p)), darkest * (1 - direct), 0.05)
                    << style << ", tone " << darkest << ", turned by " << turn << ", " << tilt;
            }
        }
    }
}

/// Root of the mean square of the differences of channels, of 1, where `b` is `a` moved by `by` pixels; away from the
/// picture's border, at which surfaces have no neighbors.
double moved_difference(const base::Image& a, const base::Image& b, glm::ivec2 by) {
    constexpr int kBorder = 4;
    double sum = 0;
    std::size_t count = 0;
    for (int y = kBorder; y < a.height - kBorder; ++y) {
        for (int x = kBorder; x < a.width - kBorder; ++x) {
            const glm::ivec2 to(x + by.x, y + by.y);
            if (to.x < kBorder || to.y < kBorder || to.x >= b.width - kBorder || to.y >= b.height - kBorder) {
                continue;
            }
            for (int c = 0; c < 3; ++c) {
                const double d = (a.pixel(x, y)[c] - b.pixel(to.x, to.y)[c]) / 255.0;
                sum += d * d;
                ++count;
            }
        }
    }
    return std::sqrt(sum / static_cast<double>(count));
}

TEST(AnchoredInk, MovesWithTheModel) {
    csg::Fineness fine;
    fine.fn = 48;
    scene::Easel easel(scene::combine(csg::Operation::Union,
                                      {scene::box({30, 30, 0}, {40, 40, 10}),
                                       scene::at({50, 50, 20}, scene::leaf(csg::Cylinder{24, 12, 8, true, fine})),
                                       scene::at({72, 40, 16}, scene::leaf(csg::Sphere{9, fine}))}));
    for (const char* style : {"hatch", "stipple"}) {
        npr::Picture p = picture(style, 0.65F, close_up(25, 55, 200, base::Projection::Orthographic));
        const base::Image before = easel.paint(p);
        EXPECT_GT(coverage(before), 0.05);
        const double pixel = 2 * p.camera.distance * std::tan(glm::radians(p.camera.fov) / 2) / p.size.y;
        const glm::dmat3 world = glm::transpose(glm::dmat3(p.camera.eye_from_world()));
        const glm::ivec2 by(7, -11);  // Of the picture, whose rows go down.
        p.camera.target -= pixel * (static_cast<double>(by.x) * world[0] - static_cast<double>(by.y) * world[1]);
        EXPECT_LE(moved_difference(before, easel.paint(p), by), 0.002) << style;
        EXPECT_GT(moved_difference(before, easel.paint(p), {0, 0}), 0.1) << style << ": the measure tells";
    }
}

/// The axis about which strokes run goes through the table of surfaces in 15 bits a coordinate.
TEST(AnchoredInk, StrokesRunAboutTheAxis) {
    csg::Fineness fine;
    fine.fn = 96;
    const glm::dmat4 lying = glm::dmat4(0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1);
    scene::Easel easel(scene::matrix(lying, scene::leaf(csg::Cylinder{400, 30, 30, true, fine})));
    base::Camera camera;
    camera.projection = base::Projection::Orthographic;
    camera.rotation = {90, 0, 0};  // From the front; the cylinder lies across.
    camera.distance = 100;
    const base::Image image = easel.paint(picture("hatch", 0.3F, camera));
    // Rings about it are seen as upright lines: pixels above each other are alike.
    double along = 0, across = 0;
    for (int y = 60; y < 100; ++y) {
        for (int x = 20; x < 140; ++x) {
            along += std::abs(image.pixel(x, y)[0] - image.pixel(x, y + 1)[0]);
            across += std::abs(image.pixel(x, y)[0] - image.pixel(x + 1, y)[0]);
        }
    }
    EXPECT_LT(8 * along, across);
}

}  // namespace
