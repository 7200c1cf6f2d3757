// Models of transparency against what rays say, and against themselves.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "npr/medium_rows.h"
#include "tests/npr/analytic.h"
#include "tests/npr/easel.h"

namespace {

using csg::Operation;
using npr::Transparency;
using scene::box;
using scene::colored;
using scene::Easel;
using scene::Model;

constexpr csg::Rgba kRed{0.9F, 0.2F, 0.1F, 0.4F}, kBlue{0.1F, 0.3F, 0.9F, 0.6F}, kWhite{1, 1, 1, 0.5F};

npr::Picture picture_of(const csg::Box& box, Transparency transparency, std::string_view style = "shaded",
                        int side = 96) {
    npr::Picture p;
    p.draw_as(*npr::find_style(style));
    p.scheme = npr::color_schemes().front();
    p.camera = scene::camera(box);
    p.size = {side, side};
    p.samples = 1;
    p.transparency = transparency;
    return p;
}

Model all(std::vector<Model> models) {
    return scene::combine(Operation::Union, std::move(models));
}

Model marked(Model model, bool background) {
    Model group = all({std::move(model)});
    (background ? group.modifiers.background : group.modifiers.highlight) = true;
    return group;
}

Model ball(double radius) {
    csg::Fineness fine;
    fine.fn = 32;
    return scene::leaf(csg::Sphere{radius, fine});
}

/// Parts that contain, cut and touch each other, with faces that two and three of them share unless they are `apart`.
std::vector<Model> parts(double apart) {
    const glm::dvec3 by(apart);
    return {scene::widget(),
            colored(kRed, box({-9, -11, -9}, {18, 6, 18})),
            colored(kBlue, box(by + glm::dvec3(-9, -11, -9), {18, 12, 9})),
            colored(kWhite, scene::combine(Operation::Difference, {ball(11), box({0, -20, -20}, {40, 40, 40})})),
            marked(box(2.0 * by + glm::dvec3(-9, -11, -9), {5, 22, 18}), true),
            marked(colored({0, 1, 0, 1}, box({4, -11, -12}, {5, 22, 18})), false)};
}

/// A scene, its picture by rays, and how far the painted one is from it.
analytic::Error error_of(const Model& model, const npr::Picture& picture) {
    const comparison::Subject subject(random_tree::make_tree(model));
    return analytic::error_of(subject, picture, Easel(model).paint(picture));
}

TEST(Transparency, ExactIsWhatRaysSay) {
    const Model model =
        all({scene::widget(), colored(kRed, box({-9, -11, -8}, {18, 6, 16})), colored(kBlue, ball(11)),
             scene::combine(Operation::Difference, {colored(kWhite, box({-4, -14, -4}, {9, 30, 9})), ball(5)})});
    const csg::Box box = Easel(model).box();
    npr::Picture picture = picture_of(box, Transparency::Exact);
    for (const auto projection : {base::Projection::Perspective, base::Projection::Orthographic}) {
        picture.camera.projection = projection;
        const analytic::Error error = error_of(model, picture);
        EXPECT_GT(error.pixels, 2000U);
        EXPECT_LE(error.rms, 1.0);
        EXPECT_LE(error.most, 2.0);
    }
}

TEST(Transparency, AnyOrderOfPartsGivesTheSameBytes) {
    std::mt19937_64 random(7);
    for (const npr::TransparencyInfo& each : npr::transparencies()) {
        const Transparency transparency = each.model;
        for (const char* style : {"shaded", "edges"}) {
            // Lines of faces that are in one place are those of the part that comes first.
            std::vector<Model> models = parts(style == std::string("edges") ? 0.3 : 0);
            Easel first(all(models));
            const npr::Picture picture = picture_of(first.box(), transparency, style, 80);
            const base::Image expected = first.paint(picture);
            EXPECT_EQ(scene::differing(first.paint(picture, 3), expected, 0), 0) << style;
            for (int i = 0; i < 6; ++i) {
                std::shuffle(models.begin(), models.end(), random);
                EXPECT_EQ(scene::differing(Easel(all(models)).paint(picture), expected, 0), 0) << style;
            }
        }
    }
}

TEST(Transparency, FacesThatPartsShareAreSeenOnce) {
    const Model one = colored(kRed, box({0, 0, 0}, {4, 4, 4}));
    const npr::Picture picture = picture_of(Easel(one).box(), Transparency::Exact);
    const base::Image once = Easel(one).paint(picture);
    EXPECT_EQ(scene::differing(Easel(all({one, one, one})).paint(picture), once, 0), 0);
    const Model opaque = colored({0.9F, 0.2F, 0.1F, 1}, box({0, 0, 0}, {4, 4, 4}));
    EXPECT_EQ(scene::differing(Easel(all({one, opaque})).paint(picture), Easel(opaque).paint(picture), 0), 0)
        << "the most opaque one";
    const Model ghost = marked(box({0, 0, 0}, {4, 4, 4}), true);
    EXPECT_EQ(scene::differing(Easel(all({ghost, one})).paint(picture), once, 0), 0) << "% only where it is alone";
    EXPECT_GT(scene::differing(Easel(all({marked(one, false)})).paint(picture), once, 4), 1000) << "# tints";
}

TEST(Transparency, NothingAndEverythingAreExact) {
    const Model inner = box({1, 1, 1}, {2, 2, 2}), outer = box({0, 0, 0}, {4, 4, 1}), solid = all({inner, outer});
    const base::Image exact = Easel(solid).paint(picture_of(Easel(solid).box(), Transparency::Exact));
    for (const npr::TransparencyInfo& each : npr::transparencies()) {
        const npr::Picture picture = picture_of(Easel(solid).box(), each.model);
        const base::Image expected = Easel(solid).paint(picture);
        if (each.model != Transparency::ViewDependent) {  // Which has its own shading.
            EXPECT_EQ(scene::differing(expected, exact, 0), 0) << each.name;
        }
        const Model clear = colored({1, 0, 0, 0}, box({0, 0, 1}, {4, 1, 2}));
        EXPECT_EQ(scene::differing(Easel(all({clear, solid})).paint(picture), expected, 0), 0) << "opacity 0";
        const Model full = colored({-1, -1, -1, 1}, solid);
        EXPECT_EQ(scene::differing(Easel(full).paint(picture), expected, 0), 0) << "opacity 1";
    }
}

TEST(Transparency, RandomModelsAreWhatRaysSay) {
    std::size_t pixels = 0, seen_through = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        std::mt19937_64 random(seed);
        const Model model = random_tree::make_model(random);
        const comparison::Subject subject(random_tree::make_tree(model));
        if (subject.geometry.box.empty()) {
            continue;
        }
        for (const csg::Part& part : subject.scene.parts) {
            seen_through += part.kind == csg::PartKind::Translucent ? 1 : 0;
        }
        for (const Transparency transparency : {Transparency::Exact, Transparency::Volume}) {
            npr::Picture picture = picture_of(subject.geometry.box, transparency, "shaded", 20);
            picture.camera = random_tree::make_camera(random, subject.geometry.box.lo, subject.geometry.box.hi);
            const analytic::Error error = error_of(model, picture);
            EXPECT_LE(error.most, 2.0) << "seed " << seed << ", " << static_cast<int>(transparency)
                                       << random_tree::camera_text(picture.camera) << random_tree::scad_text(model);
            pixels += error.pixels;
        }
    }
    EXPECT_GT(pixels, 10'000U);
    EXPECT_GT(seen_through, 20U);
}

/// An opaque cutter does not make the faces that it leaves opaque, nor does it color them.
TEST(Transparency, PartsHaveTheirOwnColorOnCuts) {
    const auto cut = [](const csg::Rgba& cutter) {
        return scene::combine(Operation::Difference, {all({colored(kRed, box({0, 0, 0}, {4, 4, 4}))}),
                                                      colored(cutter, box({1, -1, 1}, {2, 6, 2}))});
    };
    const npr::Picture picture = picture_of(Easel(cut(kBlue)).box(), Transparency::Exact);
    const base::Image expected = Easel(cut(kRed)).paint(picture);
    EXPECT_EQ(scene::differing(Easel(cut({0, 0, 1, 1})).paint(picture), expected, 0), 0);
    EXPECT_EQ(scene::differing(Easel(cut({-1, -1, -1, -1})).paint(picture), expected, 0), 0);
    EXPECT_LE(error_of(cut({0, 0, 1, 1}), picture).most, 2.0);
}

TEST(Volume, IsWhatRaysSay) {
    // Media that overlap, contain an opaque part, and are contained; one of them is said.
    const Model model =
        all({scene::widget(), colored(kRed, box({-9, -11, -8}, {18, 6, 16})), colored(kBlue, ball(11)),
             scene::combine(Operation::Difference, {colored(kWhite, box({-4, -14, -4}, {9, 30, 9})), ball(5)})});
    npr::Picture picture = picture_of(Easel(model).box(), Transparency::Volume);
    picture.media = {{"#ffffff80", 0.3F, glm::vec3(0.7F, 0.8F, 0.2F)}};
    for (const auto projection : {base::Projection::Perspective, base::Projection::Orthographic}) {
        picture.camera.projection = projection;
        const analytic::Error error = error_of(model, picture);
        EXPECT_GT(error.pixels, 2000U);
        EXPECT_LE(error.rms, 1.0);
        EXPECT_LE(error.most, 2.0);
    }
    picture.media = {{"model", 0.1F, glm::vec3(0.9F, 0.9F, 0.5F)}};
    EXPECT_LE(error_of(model, picture).most, 2.0) << "an opaque part that is said to be a medium";
}

TEST(Volume, TheEyeMayBeInsideOfOneTwoAndThree) {
    std::vector<Model> models{box({-30, 40, -30}, {60, 4, 60})};
    for (int media = 1; media <= 3; ++media) {
        const double side = 10 * media;
        models.push_back(colored(media == 2   ? kBlue
                                 : media == 1 ? kRed
                                              : kWhite,
                                 box(glm::dvec3(-side), glm::dvec3(2 * side))));
        npr::Picture picture = picture_of(Easel(all(models)).box(), Transparency::Volume);
        picture.camera.target = {0, 5, 0};
        picture.camera.rotation = {90, 0, 0};
        picture.camera.distance = 5;
        picture.camera.fov = 80;
        ASSERT_LT(glm::length(picture.camera.eye()), 1e-9);
        const analytic::Error error = error_of(all(models), picture);
        EXPECT_GT(error.pixels, 4000U);
        EXPECT_LE(error.most, 2.0) << media;
    }
}

/// Up to the Nth surface: as if what is behind the first two were not there.
TEST(Volume, ByTheFirstLayersItIsWhatIsBetweenThem) {
    const Model near = colored({1, 0, 0, 0.5F}, box({-9, -9, 2}, {18, 18, 4})),
                far = colored({0, 0, 1, 0.5F}, box({-9, -9, -6}, {18, 18, 4}));
    npr::Picture picture = picture_of(Easel(all({near, far})).box(), Transparency::Volume);
    picture.camera.projection = base::Projection::Orthographic;
    picture.camera.rotation = {0, 0, 0};
    picture.media = {{"#ff000080", 0.2F, glm::vec3(0.7F, 0.2F, 0.1F)}, {"#0000ff80", 0.2F, glm::vec3(0.1F)}};
    const auto first = [&](const Model& model, int layers) {
        const base::Image image = Easel(model).paint(picture, 0, layers);
        const auto c = image.pixel(48, 48);
        return glm::ivec3(c[0], c[1], c[2]);
    };
    EXPECT_EQ(first(all({near, far}), 2), first(near, 0));
    EXPECT_EQ(first(all({near, far}), 3), first(near, 0))
        << "the second body is entered, and how far it goes is not known";
    EXPECT_NE(first(all({near, far}), 4), first(near, 0));
}

/// A plate of the thickness that opacity is said of has that opacity.
TEST(Volume, OpacityIsThatOfTheStatedThickness) {
    // Diagonal: 30 by the frame about it; thickness 3.
    const Model frame = all({box({0, 0, 0}, {20, 20, 1}), box({0, 0, 9}, {20, 20, 1})});
    const Model plate = colored({0.2F, 0.4F, 0.6F, 0.25F}, box({2, 2, 3}, {16, 16, 3}));
    const Model model = all({scene::combine(Operation::Difference, {frame, box({1, 1, -1}, {18, 18, 12})}), plate});
    npr::Picture picture = picture_of(Easel(model).box(), Transparency::Volume);
    picture.camera.rotation = {0, 0, 0};
    picture.camera.projection = base::Projection::Orthographic;
    picture.medium_light = {1, 0};
    const csg::Box box = Easel(model).box();
    const double diagonal = glm::length(box.hi - box.lo), opacity = 1 - std::pow(0.75, 3 / (0.1 * diagonal));
    const base::Image image = Easel(model).paint(picture);
    for (int c = 0; c < 3; ++c) {
        const double expected = opacity * (c + 1) * 0.2 + (1 - opacity) * picture.scheme.background[c];
        EXPECT_NEAR(image.pixel(48, 48)[c], 255 * expected, 0.6);
    }
    EXPECT_NEAR(opacity, 0.25, 0.02);
    EXPECT_DOUBLE_EQ(npr::attenuation_of(0.25, 3), -std::log(0.75) / 3);
}

/// A white furnace: what scatters all light, in light that is the same from everywhere, is not to be seen.
TEST(Volume, KeepsEnergy) {
    Easel easel(all({colored(kWhite, ball(8)), colored(kWhite, box({0, 0, 0}, {9, 9, 9})),
                     colored({1, 1, 1, 0.99F}, box({-9, -9, -9}, {7, 7, 7}))}));
    npr::Picture picture = picture_of(easel.box(), Transparency::Volume);
    picture.scheme.background = picture.scheme.background_stop = glm::vec3(1);
    picture.medium_light = {1, 0};
    const base::Image image = easel.paint(picture);
    EXPECT_EQ(*std::min_element(image.rgba.begin(), image.rgba.end()), 255);
    picture.medium_light = {0.5F, 0};
    EXPECT_GT(scene::differing(easel.paint(picture), image, 4), 1000);
}

TEST(Transparencies, HaveNames) {
    EXPECT_EQ(npr::transparencies().front().model, Transparency::Exact);
    for (const npr::TransparencyInfo& each : npr::transparencies()) {
        EXPECT_EQ(npr::find_transparency(each.name), &each);
    }
    EXPECT_EQ(npr::find_transparency("glass"), nullptr);
}

}  // namespace
