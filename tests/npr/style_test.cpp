// What holds for every style.
#include "npr/style.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/npr/scene.h"
#include "tests/support/gl_test.h"

namespace {

using csg::Operation;

scene::Model nothing() {
    return scene::combine(Operation::Intersection,
                          {scene::box({0, 0, 0}, glm::dvec3(1)), scene::box({2, 0, 0}, glm::dvec3(1))});
}

/// A picture of one face only, and nothing else in sight.
base::Camera close_up() {
    base::Camera camera;
    camera.target = {50, 50, 10};
    camera.rotation = {0, 0, 0};
    camera.distance = 20;
    return camera;
}
scene::Model slab() {
    return scene::box({0, 0, 0}, {100, 100, 10});
}

std::size_t differing(const base::Image& a, const base::Image& b, int tolerance = 0) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        bool same = true;
        for (std::size_t c = i; c < i + 4; ++c) {
            same = same && std::abs(a.rgba[c] - b.rgba[c]) <= tolerance;
        }
        count += same ? 0 : 1;
    }
    return count;
}

int darkest(const base::Image& image) {
    int least = 255;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        least = std::min<int>(least, image.rgba[i + 1]);
    }
    return least;
}

class StyleTest : public test_support::GlTest {
  protected:
    /// In a studio of its own, so that nothing is kept from other pictures.
    base::Image draw(const scene::Model& model, const scene::Studio::Request& request) {
        scene::Studio studio(gl());
        return studio.draw(model, request);
    }
};

TEST_P(StyleTest, SamePictureTwice) {
    for (const npr::StyleInfo& info : npr::styles()) {
        const scene::Studio::Request request{.style = info.name, .samples = 4};
        EXPECT_EQ(draw(scene::widget(), request).rgba, draw(scene::widget(), request).rgba) << info.name;
    }
}

TEST_P(StyleTest, EmptySceneIsBackground) {
    for (const npr::StyleInfo& info : npr::styles()) {
        const base::Image image = draw(nothing(), {.style = info.name});
        // Paper that is drawn on by hand has a grain.
        const bool by_hand = info.name.starts_with("sketch") || info.name == "chalk" || info.name == "strokes";
        const int grain = by_hand ? 8 : 0;
        for (std::size_t i = 0; i < image.rgba.size(); ++i) {
            ASSERT_NEAR(image.rgba[i], image.rgba[i % 4], grain) << info.name;
        }
        const base::Image clear = draw(nothing(), {.style = info.name, .samples = 4, .transparent_background = true});
        EXPECT_EQ(*std::max_element(clear.rgba.begin(), clear.rgba.end()), 0) << info.name;
    }
}

TEST_P(StyleTest, TransparentBackgroundShowsOnlyTheModel) {
    for (const npr::StyleInfo& info : npr::styles()) {
        const base::Image image = draw(scene::widget(), {.style = info.name, .transparent_background = true});
        for (const auto& [x, y] : {std::pair{0, 0}, {63, 0}, {0, 63}, {63, 63}}) {
            EXPECT_EQ(image.pixel(x, y)[3], 0) << info.name;
        }
        // On the block, beside its bores.
        const bool seen_through = info.name == "xray" || info.name == "tech";
        EXPECT_GT(image.pixel(32, 31)[3], seen_through ? 60 : 250) << info.name;
    }
}

TEST_P(StyleTest, LinesAreDrawnAcrossThePicturesSize) {
    // A box seen from the front: dark lines where its outline is, for each style that draws any on a light ground.
    const scene::Model box = scene::box({0, 0, 0}, glm::dvec3(10));
    for (const std::string_view style : {"edges", "xray", "sketch"}) {
        for (const int size : {64, 200}) {
            const base::Image image = draw(box, {.style = style, .size = {size, size}, .samples = 4});
            EXPECT_LT(darkest(image), 110) << style << ' ' << size;
        }
    }
}

TEST_P(StyleTest, HiddenEdgesOfTheBlueprint) {
    // From above, a box in a box shows its outline in the second layer only.
    const scene::Model model = scene::combine(
        Operation::Difference, {scene::box({0, 0, 0}, glm::dvec3(10)), scene::box({3, 3, 3}, glm::dvec3(4))});
    const base::Image all = draw(model, {.style = "blueprint", .settings = {{"tone", "0"}}});
    const base::Image visible = draw(model, {.style = "blueprint", .settings = {{"tone", "0"}, {"hidden", "0"}}});
    const base::Image one = draw(model, {.style = "blueprint", .settings = {{"tone", "0"}, {"layers", "1"}}});
    EXPECT_GT(differing(all, visible, 10), 100U);
    EXPECT_EQ(differing(visible, one), 0U);
    const base::Image white = draw(model, {.style = "blueprint", .settings = {{"ground", "white"}}});
    EXPECT_GT(white.pixel(1, 1)[0], 200);
    EXPECT_LT(all.pixel(1, 1)[0], 60);
}

TEST_P(StyleTest, XrayShowsWhatIsInside) {
    const scene::Model solid = scene::box({0, 0, 0}, glm::dvec3(10));
    const scene::Model hollow = scene::combine(Operation::Difference, {solid, scene::box({3, 3, 3}, glm::dvec3(4))});
    EXPECT_GT(differing(draw(solid, {.style = "xray"}), draw(hollow, {.style = "xray"}), 8), 200U);
    EXPECT_EQ(differing(draw(solid, {.style = "edges"}), draw(hollow, {.style = "edges"})), 0U);
    // Front and back in order: the first layer counts most.
    const auto first = draw(solid, {.style = "xray", .settings = {{"opacity", "1"}, {"cue", "0"}}});
    const auto only = draw(solid, {.style = "xray", .settings = {{"opacity", "1"}, {"cue", "0"}, {"layers", "1"}}});
    EXPECT_EQ(differing(first, only), 0U);
}

TEST_P(StyleTest, SeedOfASketch) {
    const auto sketch = [&](const char* seed, const char* medium) {
        return draw(scene::widget(), {.style = "sketch", .settings = {{"seed", seed}, {"medium", medium}}});
    };
    for (const char* medium : {"pencil", "ink", "chalk"}) {
        const base::Image one = sketch("1", medium);
        EXPECT_EQ(one.rgba, sketch("1", medium).rgba) << medium;
        EXPECT_GT(differing(one, sketch("2", medium)), 200U) << medium;
    }
    EXPECT_GT(differing(sketch("1", "pencil"), sketch("1", "chalk"), 8), 200U);
}

TEST_P(StyleTest, AKeptSketchIsDrawnAnewWhenTold) {
    // The noise is kept from picture to picture; another seed, size or view must not get the old one.
    scene::Studio studio(gl());
    const npr::StyleInfo& info = *npr::find_style("sketch");
    const auto style = info.make(gl());
    const auto kept = [&](const scene::Studio::Request& request) {
        return studio.draw_with(*style, scene::widget(), request).rgba;
    };
    for (const auto& settings : {std::map<std::string, std::string>{{"seed", "1"}},
                                 {{"seed", "2"}},
                                 {{"seed", "2"}, {"anchor", "model"}},
                                 {{"seed", "2"}, {"medium", "chalk"}},
                                 {{"seed", "1"}}}) {
        for (const int size : {48, 64}) {
            const scene::Studio::Request request{.style = "sketch", .settings = settings, .size = {size, size}};
            EXPECT_EQ(kept(request), draw(scene::widget(), request).rgba);
        }
    }
}

TEST_P(StyleTest, AKeptSketchOnTheModelFollowsEveryPartOfTheCamera) {
    scene::Studio studio(gl());
    const auto style = npr::find_style("sketch")->make(gl());
    const base::Camera usual;
    base::Camera wide;
    base::Camera flat;
    wide.fov = 60;
    flat.projection = base::Projection::Orthographic;
    for (const base::Camera& camera : {usual, wide, usual, flat}) {
        const scene::Studio::Request request{
            .style = "sketch", .settings = {{"anchor", "model"}}, .size = {48, 48}, .camera = &camera};
        EXPECT_EQ(studio.draw_with(*style, scene::widget(), request).rgba, draw(scene::widget(), request).rgba);
    }
}

TEST_P(StyleTest, JitterNeverMovesNoise) {
    // One face fills the picture, so that every sample sees the same; grain and wash must not be blurred by averaging.
    const base::Camera camera = close_up();
    const auto sketch = [&](int samples) {
        return draw(slab(), {.style = "sketch", .settings = {{"hatch", "0"}}, .samples = samples, .camera = &camera});
    };
    const base::Image one = sketch(1);
    EXPECT_GT(differing(one, base::Image{one.width, one.height, std::vector<std::uint8_t>(one.rgba.size(), 200)}), 0U);
    EXPECT_NE(std::set<std::uint8_t>(one.rgba.begin(), one.rgba.end()).size(), 4U) << "no grain at all";
    EXPECT_LE(differing(one, sketch(16), 1), 0U);
}

TEST_P(StyleTest, ModelAnchorMovesTheNoiseAlong) {
    // With the noise anchored to the model, a camera that moves along with the model's translation changes nothing.
    const auto sketch = [&](const glm::dvec3& place, const char* anchor, double pan) {
        base::Camera camera = scene::camera({place, place + glm::dvec3(10)});
        camera.projection = base::Projection::Orthographic;
        // Pan by whole pixels: the picture is the same, shifted.
        const double pixel = 2 * camera.distance * std::tan(glm::radians(camera.fov / 2)) / 64;
        const glm::dmat3 world_from_eye = glm::transpose(glm::dmat3(camera.eye_from_world()));
        camera.target += world_from_eye * glm::dvec3(pan * pixel, 0, 0);
        return draw(
            scene::box(place, glm::dvec3(10)),
            {.style = "sketch",
             .settings = {{"anchor", anchor}, {"medium", "ink"}, {"color", "0"}, {"hatch", "0"}, {"wobble", "6"}},
             .camera = &camera});
    };
    const auto shifted = [](const base::Image& a, const base::Image& b, int by) {
        std::size_t count = 0;
        for (int y = 0; y < a.height; ++y) {
            for (int x = by; x < a.width; ++x) {
                count += std::abs(a.pixel(x, y)[1] - b.pixel(x - by, y)[1]) > 24 ? 1 : 0;
            }
        }
        return count;
    };
    const base::Image still = sketch({0, 0, 0}, "model", 0);
    EXPECT_EQ(differing(still, sketch({7, 7, 7}, "model", 0), 24), 0U);
    EXPECT_LE(shifted(still, sketch({0, 0, 0}, "model", 5), 5), 4U);
    EXPECT_GT(shifted(sketch({0, 0, 0}, "picture", 0), sketch({0, 0, 0}, "picture", 5), 5), 40U);
}

TEST_P(StyleTest, StrokesOvershootAndStrayFromTheEdge) {
    base::Camera camera;
    camera.rotation = {0, 0, 0};
    camera.projection = base::Projection::Orthographic;
    base::view_all(camera, glm::dvec3(0), glm::dvec3(10), true);
    const auto sketch = [&](const char* overshoot, const char* wobble) {
        return draw(scene::box({0, 0, 0}, glm::dvec3(10)), {.style = "sketch",
                                                            .settings = {{"overshoot", overshoot},
                                                                         {"wobble", wobble},
                                                                         {"strokes", "1"},
                                                                         {"medium", "ink"},
                                                                         {"color", "0"},
                                                                         {"hatch", "0"}},
                                                            .size = {256, 256},
                                                            .camera = &camera});
    };
    const auto breadth = [](const base::Image& image) {
        int lo = image.width, hi = 0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                if (image.pixel(x, y)[1] < 215) {
                    lo = std::min(lo, x);
                    hi = std::max(hi, x);
                }
            }
        }
        return hi - lo;
    };
    const base::Image plain = sketch("0", "0"), beyond = sketch("30", "0");
    // 30 pixels of a 512th are 15 here, on each side; the last third is faint.
    EXPECT_GE(breadth(beyond), breadth(plain) + 16);
    EXPECT_LE(breadth(beyond), breadth(plain) + 30);
    EXPECT_GT(differing(plain, sketch("0", "12"), 24), 300U);
}

TEST_P(StyleTest, ParametersAtTheirLimits) {
    for (const npr::StyleInfo& info : npr::styles()) {
        for (const npr::Parameter& p : info.parameters) {
            if (p.kind != npr::ParameterKind::Number && p.kind != npr::ParameterKind::Integer &&
                p.kind != npr::ParameterKind::Choice) {
                continue;
            }
            for (const float limit : {p.min, p.max}) {
                const npr::Value value =
                    p.kind == npr::ParameterKind::Number ? npr::Value(limit) : npr::Value(static_cast<int>(limit));
                const base::Image image = draw(
                    scene::widget(),
                    {.style = info.name, .settings = {{std::string(p.name), npr::text(p, value)}}, .size = {32, 32}});
                // Not a number would show as a hole.
                for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
                    ASSERT_EQ(image.rgba[i], 255) << info.name << ' ' << p.name << '=' << npr::text(p, value);
                }
            }
        }
    }
}

TEST_P(StyleTest, EyeInsideTheModelAndTinyPictures) {
    base::Camera inside;
    inside.target = {5, 5, 5};
    inside.distance = 1e-3;
    scene::Studio studio(gl());
    for (const npr::StyleInfo& info : npr::styles()) {
        const auto style = info.make(gl());
        for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 40), glm::ivec2(40, 1), glm::ivec2(3, 3)}) {
            const base::Image image =
                studio.draw_with(*style, scene::box({0, 0, 0}, glm::dvec3(10)),
                                 {.style = info.name, .size = size, .samples = 4, .camera = &inside});
            EXPECT_EQ(image.rgba.size(), static_cast<std::size_t>(4 * size.x * size.y));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Contexts, StyleTest, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

}  // namespace
