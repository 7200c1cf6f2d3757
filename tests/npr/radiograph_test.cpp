// Thickness against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "npr/styles/radiograph.h"
#include "tests/npr/easel.h"
#include "tests/support/gl_test.h"

namespace {

using csg::Operation;
using scene::box;
using scene::Easel;
using scene::Model;

constexpr int kSide = 128;

npr::Picture picture_of(const csg::Box& box, int part = 0) {
    npr::Picture p;
    p.draw_as(*npr::find_style("radiograph"));
    p.parameters.read("colors", "values");
    p.parameters.set("part", part);
    p.scheme = npr::color_schemes().front();
    p.camera = scene::camera(box);
    p.size = {kSide, kSide};
    p.samples = 1;
    return p;
}

/// A line, and the length of it that is within something.
struct Line {
    glm::dvec3 origin, direction;  ///< A unit vector.
};

struct Span {
    double from = 0, to = 0;
    [[nodiscard]] double length() const { return std::max(0.0, to - from); }
};

Span of_box(const Line& line, const glm::dvec3& lo, const glm::dvec3& hi) {
    Span span{0, std::numeric_limits<double>::max()};
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (lo[axis] - line.origin[axis]) / line.direction[axis];
        const double b = (hi[axis] - line.origin[axis]) / line.direction[axis];
        span = {std::max(span.from, std::min(a, b)), std::min(span.to, std::max(a, b))};
    }
    return span;
}

/// Of the ball about the origin (2 axes: the cylinder about z without ends).
Span of_round(const Line& line, double radius, int axes) {
    double a = 0, b = 0, c = -radius * radius;
    for (int axis = 0; axis < axes; ++axis) {
        a += line.direction[axis] * line.direction[axis];
        b += line.direction[axis] * line.origin[axis];
        c += line.origin[axis] * line.origin[axis];
    }
    const double root = b * b - a * c;
    return root < 0 ? Span{} : Span{std::max(0.0, (-b - std::sqrt(root)) / a), (-b + std::sqrt(root)) / a};
}

/// Compares all pixels; `slack`: absolute, beside 0.1%.
void expect_thickness(const Model& model, const npr::Picture& picture, double slack,
                      const std::function<double(const Line&)>& expected) {
    Easel easel(model);
    const std::vector<glm::vec4> values = easel.light(picture);
    const base::View view(picture.camera, picture.size, easel.box().lo, easel.box().hi);
    int within = 0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const base::View::Ray ray = view.ray(x, y);
            const double begin = view.orthographic() ? view.near_distance() : 0;
            const double length = expected({ray.origin + begin * ray.direction, glm::normalize(ray.direction)});
            const double measured = values[static_cast<std::size_t>(y * kSide + x)].r;
            ASSERT_NEAR(measured, length, 1e-3 * length + slack) << x << ", " << y;
            within += length > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(within, 1000);
}

csg::Fineness fine() {
    csg::Fineness f;
    f.fn = 720;
    return f;
}

TEST(Radiograph, OfABoxIsThatOfTheBox) {
    const Model model = box({-3, -2, -1}, {6, 4, 2});
    npr::Picture picture = picture_of(Easel(model).box());
    for (const auto projection : {base::Projection::Perspective, base::Projection::Orthographic}) {
        picture.camera.projection = projection;
        // Beside an edge a ray may hit or miss by the rounding of its vertices: 1/256 pixel, of a slope of 1.
        const double pixel = 2 * 12.0 / kSide;
        expect_thickness(model, picture, pixel / 16, [](const Line& line) {
            return of_box(line, {-3, -2, -1}, {3, 2, 1}).length();
        });
    }
}

TEST(Radiograph, OfABallIsItsChord) {
    // An inscribed mesh: chords are shorter by what facets lie below the ball, twice, at a slant.
    const Model model = scene::leaf(csg::Sphere{5, fine()});
    const npr::Picture picture = picture_of(Easel(model).box());
    const double sagitta = 5 * (1 - std::cos(glm::radians(360.0 / 720)));
    expect_thickness(model, picture, 2 * std::sqrt(2 * 5 * 2 * sagitta),
                     [](const Line& line) { return of_round(line, 5, 3).length(); });
    // Away from the rim the slant is small.
    Easel easel(model);
    const std::vector<glm::vec4> values = easel.light(picture);
    const base::View view(picture.camera, picture.size, easel.box().lo, easel.box().hi);
    for (int i = -20; i <= 20; ++i) {
        const base::View::Ray ray = view.ray(kSide / 2 + i, kSide / 2 + i / 2);
        const double chord = of_round({ray.origin, glm::normalize(ray.direction)}, 5, 3).length();
        EXPECT_NEAR(values[static_cast<std::size_t>((kSide / 2 + i / 2) * kSide + kSide / 2 + i)].r, chord,
                    1e-3 * chord);
    }
}

TEST(Radiograph, OfABoredBlockIsTheBlockWithoutTheBore) {
    const Model model = scene::combine(
        Operation::Difference, {box({-4, -4, -3}, {8, 8, 6}), scene::leaf(csg::Cylinder{10, 2, 2, true, fine()})});
    npr::Picture picture = picture_of(Easel(model).box());
    for (const glm::dvec3& rotation : {glm::dvec3(0, 0, 0), glm::dvec3(50, 0, 30)}) {
        picture.camera.rotation = rotation;
        const double slant = 2 * std::sqrt(2 * 2 * 2 * 2 * (1 - std::cos(glm::radians(360.0 / 720))));
        expect_thickness(model, picture, slant + 2 * 14.0 / kSide / 16, [](const Line& line) {
            const Span block = of_box(line, {-4, -4, -3}, {4, 4, 3}), bore = of_round(line, 2, 2);
            return block.length() - Span{std::max(block.from, bore.from), std::min(block.to, bore.to)}.length();
        });
    }
}

/// By part, and in all, where what parts share counts once; `%` and `#` do not; and from inside.
TEST(Radiograph, CountsPartsOnceAndBeginsAtTheEye) {
    const csg::Rgba glass{1, 0, 0, 0.5F};
    Model ghost = scene::combine(Operation::Union, {box({-9, -9, -9}, {18, 18, 18})});
    ghost.modifiers.background = true;
    Model marked = scene::combine(Operation::Union, {box({-2, -2, -2}, {4, 4, 4})});
    marked.modifiers.highlight = true;
    const Model model = scene::combine(Operation::Union, {box({-2, -2, -2}, {4, 4, 4}), marked,
                                                          scene::colored(glass, box({-1, -1, -1}, {2, 2, 6})), ghost});
    npr::Picture picture = picture_of(Easel(model).box());
    picture.camera.rotation = {0, 0, 0};
    picture.camera.projection = base::Projection::Orthographic;
    const auto middle = [&](int part) {
        picture.parameters.set("part", part);
        return Easel(model).light(picture)[kSide / 2 * kSide + kSide / 2].r;
    };
    EXPECT_NEAR(middle(0), 7, 1e-3);
    EXPECT_NEAR(middle(1), 4, 1e-3);
    EXPECT_NEAR(middle(2), 6, 1e-3);
    EXPECT_EQ(middle(9), 0);
    picture.camera.projection = base::Projection::Perspective;
    picture.camera.target = {0, 0, 0};
    picture.camera.distance = 1.5;
    EXPECT_NEAR(middle(1), 3.5, 4e-3);
    EXPECT_NEAR(middle(2), 2.5, 4e-3);
}

TEST(Radiograph, TonesRunFromGroundToFull) {
    EXPECT_EQ(npr::radiograph_tone(0, 0), glm::vec3(0));
    EXPECT_EQ(npr::radiograph_tone(1, 0), glm::vec3(1));
    EXPECT_EQ(npr::radiograph_tone(1, 1), glm::vec3(0));
    EXPECT_EQ(npr::radiograph_tone(2, 1), glm::vec3(1));
}

class RadiographGl : public test_support::GlTest {};

TEST_P(RadiographGl, IsTheSameByOpenGl) {
    Easel easel(scene::widget());
    const npr::Picture picture = picture_of(easel.box());
    const std::vector<glm::vec4> painted = easel.light(picture), drawn = easel.light(gl(), picture);
    ASSERT_EQ(painted.size(), drawn.size());
    for (std::size_t i = 0; i < painted.size(); ++i) {
        ASSERT_NEAR(painted[i].r, drawn[i].r, 1e-4);
    }
}

INSTANTIATE_TEST_SUITE_P(Contexts, RadiographGl, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

}  // namespace
