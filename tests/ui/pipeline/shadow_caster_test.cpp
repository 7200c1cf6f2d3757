// Cast shadows: against closed forms, ray by ray, of both painters, through sections, and in parts' own styles.
#include "ui/pipeline/picture/shadow_caster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "npr/samples.h"
#include "npr/style.h"
#include "tests/csg/scad/evaluate_text.h"
#include "tests/support/gl_test.h"
#include "ui/pipeline/infinity.h"
#include "ui/pipeline/inspection/solid_probe.h"
#include "ui/pipeline/picture/renderer.h"
#include "ui/pipeline/sections.h"

namespace ui {
namespace {

std::shared_ptr<const Model> model_of(const std::string& text) {
    const test::Run run = test::run(text);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    return ModelBuilder().build(run.evaluation.tree);
}

PictureRequest picture_of(const Model& model, const glm::dvec3& rotation) {
    PictureRequest picture;
    picture.draw_as(*npr::find_style("ntone"));
    picture.size = {210, 190};
    picture.samples = 1;
    picture.camera.projection = base::Projection::Orthographic;
    picture.camera.rotation = rotation;
    picture.camera.target = model.geometry.box.center();
    picture.camera.distance = 0.62 * model.geometry.box.diagonal() / std::tan(glm::radians(0.5 * picture.camera.fov));
    return picture;
}

/// What one sample of a picture sees, and where the caster says that it is dark.
struct Seen {
    Seen(const Model& of, const PictureRequest& picture, int layers = 1)
        : model(of),
          view(npr::sample_view(picture, 0, of.geometry.box.lo, of.geometry.box.hi)),
          stack(renderer.first_layers(of, view, layers)),
          bits(ShadowCaster(of).shadows(view, *stack)) {}

    [[nodiscard]] bool dark(int layer, int x, int y) const {
        return (bits[static_cast<std::size_t>(y * stack->size.x + x)] >> layer & 1U) != 0;
    }
    [[nodiscard]] glm::dvec3 point(const layers::Surface& s, int x, int y) const {
        const csg::solid::Plane& plane = model.geometry.planes.planes()[s.plane];
        const base::View::Ray ray = view.ray(x, y);
        return ray.origin + (plane.offset - glm::dot(plane.normal, ray.origin)) /
                                glm::dot(plane.normal, ray.direction) * ray.direction;
    }
    /// Calls of(surface, point, x, y) for all that is seen of a layer.
    template <typename Of>
    void for_each(int layer, const Of& of) const {
        for (int y = 0; y < stack->size.y; ++y) {
            for (int x = 0; x < stack->size.x && layer < stack->layers; ++x) {
                const layers::Surface s = stack->at(layer, x, y);
                if (s.depth > 0) {
                    of(s, point(s, x, y), x, y);
                }
            }
        }
    }

    const Model& model;
    Renderer renderer{{}, Painter::Cpu};
    base::View view;
    std::shared_ptr<const layers::HostStack> stack;
    std::vector<npr::ShadowBits> bits;
};

/// Does a ray from the point toward the light meet the box?
bool meets(const csg::Box& box, const glm::dvec3& point, const glm::dvec3& light) {
    double from = 0, to = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.lo[axis] - point[axis]) / light[axis], b = (box.hi[axis] - point[axis]) / light[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from < to;
}

/// How many places on top of the plate (z = 2) are dark, all of which `boxes` keep the light from, and no others.
int shadow_on_plate(const Seen& seen, const std::vector<csg::Box>& boxes, int layer = 0) {
    const glm::dvec3 light = npr::toward_light(seen.view);
    int dark = 0;
    seen.for_each(layer, [&](const layers::Surface&, const glm::dvec3& p, int x, int y) {
        if (std::abs(p.z - 2) > 1e-9) {
            return;
        }
        const bool expected =
            std::any_of(boxes.begin(), boxes.end(), [&](const csg::Box& box) { return meets(box, p, light); });
        dark += expected ? 1 : 0;
        EXPECT_EQ(seen.dark(layer, x, y), expected) << p.x << ", " << p.y;
    });
    return dark;
}

const char* const kPlate = "cube([40, 30, 2]);";
const csg::Box kPost{{22, 8, 2}, {26, 13, 9}};
const std::string kOnPlate = std::string(kPlate) + "translate([22, 8, 2]) cube([4, 5, 7]);";

TEST(ShadowCaster, TheShadowOfABoxIsItsProjection) {
    for (const glm::dvec3& rotation : {glm::dvec3(0), glm::dvec3(55, 0, 25), glm::dvec3(40, 0, 200)}) {
        const auto model = model_of(kOnPlate);
        PictureRequest picture = picture_of(*model, rotation);
        EXPECT_GT(shadow_on_plate(Seen(*model, picture), {kPost}), 100);
        picture.camera.projection = base::Projection::Perspective;
        EXPECT_GT(shadow_on_plate(Seen(*model, picture), {kPost}), 100);
    }
}

TEST(ShadowCaster, LightFallsThroughWhatIsTakenAway) {
    // A wall with a window, as a difference; and what is left of it as boxes.
    const auto model = model_of(std::string(kPlate) +
                                "difference() { translate([24, 4, 1]) cube([2, 20, 15]); translate([20, 10, 5]) "
                                "cube([9, 6, 6]); }");
    const Seen seen(*model, picture_of(*model, {20, 0, 10}));
    EXPECT_GT(shadow_on_plate(seen, {{{24, 4, 2}, {26, 10, 16}},
                                     {{24, 16, 2}, {26, 24, 16}},
                                     {{24, 10, 2}, {26, 16, 5}},
                                     {{24, 10, 11}, {26, 16, 16}}}),
              500);
}

TEST(ShadowCaster, LightPassesWhatIsSeenThrough) {
    for (const char* const mark : {"%", "color([1, 0, 0, 0.5])"}) {
        const auto model = model_of(std::string(kPlate) + mark + "translate([22, 8, 3]) cube([4, 5, 7]);");
        const Seen seen(*model, picture_of(*model, {30, 0, 20}), 0);
        for (int layer = 0; layer < 3; ++layer) {
            EXPECT_EQ(shadow_on_plate(seen, {}, layer), 0) << mark;
        }
    }
}

TEST(ShadowCaster, ShadowsFallOnEachLayerThatIsSeen) {
    // A sheet of glass high above the plate, and a post through both.
    const auto model = model_of(std::string(kPlate) +
                                "translate([22, 8, 2]) cube([4, 5, 20]); color([0, 0, 1, 0.3]) difference() { "
                                "translate([0, 0, 10]) cube([40, 30, 1]); translate([22, 8, 9]) cube([4, 5, 3]); }");
    const Seen seen(*model, picture_of(*model, {30, 0, 20}), 0);
    const csg::Box post{{22, 8, 2}, {26, 13, 22}};
    const glm::dvec3 light = npr::toward_light(seen.view);
    std::array<int, 2> dark{};
    for (int layer = 0; layer < seen.stack->layers; ++layer) {
        seen.for_each(layer, [&](const layers::Surface& s, const glm::dvec3& p, int x, int y) {
            const bool on_glass = std::abs(p.z - 11) < 1e-9, on_plate = std::abs(p.z - 2) < 1e-9 && !s.leaving;
            if (layer > 0 && !on_plate) {
                return;
            }
            bool hidden = false;  // By the post, which is no glass.
            for (int before = 0; before < layer; ++before) {
                hidden =
                    hidden || model->scene.parts[model->scene.leaves[seen.stack->at(before, x, y).leaf].part].kind ==
                                  csg::PartKind::Solid;
            }
            if ((on_glass || on_plate) && !hidden) {
                EXPECT_EQ(seen.dark(layer, x, y), meets(post, p, light)) << layer << ": " << p.x << ", " << p.y;
                dark[on_glass ? 0 : 1] += seen.dark(layer, x, y) ? 1 : 0;
            }
        });
    }
    EXPECT_GT(dark[0], 100);
    EXPECT_GT(dark[1], 100);
}

TEST(ShadowCaster, WhatIsCutAwayCastsNone) {
    const npr::Sections by{{{npr::PlaneSection{{0, 0, 1}, 5, npr::PlaneSection::Away::Beyond}, "plane"}}, {}, 0};
    ModelBuilder builder;
    builder.cut(by);
    const auto model = builder.build(test::run(kOnPlate).evaluation.tree);
    SectionedModel keeper;
    const Model& left = keeper.cut(model, resolved(by, model->box, {}));
    EXPECT_GT(shadow_on_plate(Seen(left, picture_of(*model, {30, 0, 20})), {{kPost.lo, {26, 13, 5}}}), 50);
}

/// The same by rays that know what holds the point which they start from.
bool dark_by_ray(const SolidProbe& probe, PartRay& ray, const glm::dvec3& point, const glm::dvec3& normal,
                 const glm::dvec3& light) {
    SolidProbe::Sides sides;
    probe.sides(point, normal, sides);
    return ray.enter(point, light, sides.front, kInfinity).has_value();
}

TEST(ShadowCaster, CurvedSolidsAreAsRayByRay) {
    const auto model = model_of(
        "difference() { sphere(10, $fn = 60); translate([-4, 4, 3]) cylinder(h = 30, r = 4, $fn = 30); rotate([50, 20, "
        "0]) cylinder(h = 40, r = 3, center = true, $fn = 24); } translate([4, -6, 0]) rotate([90, 0, 40]) "
        "rotate_extrude($fn = 40) translate([12, 0]) circle(1, $fn = 12);");
    const Seen seen(*model, picture_of(*model, {55, 0, 25}));
    const SolidProbe probe(model->scene, model->geometry);
    const ExpressionLinks links(model->scene);
    PartRay ray(probe, links);
    const glm::dvec3 light = npr::toward_light(seen.view);
    int dark = 0, differ = 0;
    seen.for_each(0, [&](const layers::Surface& s, const glm::dvec3& p, int x, int y) {
        glm::dvec3 normal = model->geometry.planes.planes()[s.plane].normal;
        normal = glm::dot(normal, seen.view.ray(x, y).direction) > 0 ? -normal : normal;
        const bool expected = glm::dot(normal, light) > 0 && dark_by_ray(probe, ray, p, normal, light);
        dark += expected ? 1 : 0;
        differ += expected != seen.dark(0, x, y) ? 1 : 0;
    });
    EXPECT_GT(dark, 300);
    EXPECT_EQ(differ, 0);
}

TEST(ShadowCaster, ABallsShadowIsAnEllipse) {
    // From above, a pixel is a tenth of a unit; the ball's polygon is within half of that.
    const auto model =
        model_of("translate([0, 0, -1]) cube([60, 60, 2], center = true); translate([0, 0, 8]) sphere(6, $fn = 160);");
    PictureRequest picture = picture_of(*model, {0, 0, 0});
    const Seen seen(*model, picture);
    const glm::dvec3 light = npr::toward_light(seen.view), center(0, 0, 8);
    const double pixel = 2 * 0.62 * model->geometry.box.diagonal() / picture.size.y;
    int inside = 0;
    seen.for_each(0, [&](const layers::Surface&, const glm::dvec3& p, int x, int y) {
        const glm::dvec3 to = center - p;
        const double beside = glm::length(to - glm::dot(to, light) * light);
        if (std::abs(p.z) < 1e-9 && std::abs(beside - 6) > pixel) {
            inside += beside < 6 ? 1 : 0;
            EXPECT_EQ(seen.dark(0, x, y), beside < 6) << p.x << ", " << p.y;
        }
    });
    EXPECT_GT(inside, 300);
}

int differing(const base::Image& a, const base::Image& b, int by) {
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            most = std::max(most, std::abs(a.rgba[i + c] - b.rgba[i + c]));
        }
        count += most > by ? 1 : 0;
    }
    return count;
}

class ShadowPictures : public test_support::GlTest {};

TEST_P(ShadowPictures, BothPaintersDrawTheSame) {
    const auto model = model_of(kOnPlate);
    for (const char* const style : {"ntone", "toon", "gooch"}) {
        PictureRequest picture = picture_of(*model, {55, 0, 25});
        picture.draw_as(*npr::find_style(style));
        picture.parameters.read("shadows", "off");
        Renderer cpu({}, Painter::Cpu), opengl(*context_, {}, Painter::OpenGl);
        const base::Image plain = cpu.render(*model, picture);
        EXPECT_LE(differing(plain, opengl.render(*model, picture), 3), 40) << style;
        picture.parameters.read("shadows", "on");
        const base::Image dark = cpu.render(*model, picture);
        EXPECT_GT(differing(plain, dark, 3), 100) << style;
        EXPECT_LE(differing(dark, opengl.render(*model, picture), 3), 40) << style;
    }
}

TEST(PartShadows, PartsInStylesOfTheirOwnLieInTheSameShadows) {
    const auto model = model_of(std::string("color(\"red\")") + kPlate +
                                "color(\"green\") translate([22, 8, 2]) cube([4, 5, 7]); color([0, 0, 1, 0.4]) "
                                "translate([5, 5, 12]) cube([30, 20, 1]);");
    PictureRequest picture = picture_of(*model, {55, 0, 25});
    picture.parameters.read("width", "0");
    Renderer renderer({}, Painter::Cpu);
    const base::Image whole = renderer.render(*model, picture);
    picture.parameters.read("shadows", "off");
    EXPECT_GT(differing(whole, renderer.render(*model, picture), 3), 100);
    picture.parameters.read("shadows", "on");
    npr::PartStyle own;
    own.of.by_color = true;
    own.of.color = {1, 0, 0};
    own.style = picture.style;
    own.parameters = picture.parameters;
    picture.part_styles.push_back(own);
    EXPECT_LE(differing(whole, renderer.render(*model, picture), 3), 100);  // Some of their common edges.
}

TEST(PartShadows, AnEditedModelHasItsOwnShadows) {
    const auto one = model_of(kOnPlate), other = model_of(kPlate);
    Renderer renderer({}, Painter::Cpu);
    PictureRequest picture = picture_of(*one, {55, 0, 25});
    (void)renderer.render(*one, picture);
    const base::Image again = renderer.render(*other, picture);
    EXPECT_EQ(differing(again, Renderer({}, Painter::Cpu).render(*other, picture), 0), 0);
}

INSTANTIATE_TEST_SUITE_P(Contexts, ShadowPictures, testing::Values(gl::ContextKind::Egl), test_support::context_name);

}  // namespace
}  // namespace ui
