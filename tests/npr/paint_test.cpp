// What the CPU paints is what OpenGL draws, up to rounding.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "npr/srgb.h"
#include "tests/npr/easel.h"
#include "tests/npr/golden_tolerance.h"
#include "tests/support/gl_test.h"

namespace {

using csg::Operation;
using scene::differing;
using scene::Easel;

struct View {
    const char* name;
    base::Camera camera;
    glm::ivec2 size;
    int samples;
    bool transparent_background;
};

/// Two colors, a cut, a part that is seen through, smooth and sharp edges.
scene::Model mixed() {
    return scene::combine(Operation::Union,
                          {scene::colored({0.35F, 0.5F, 0.7F, 1}, scene::widget()), scene::flush_blocks(),
                           scene::colored({0.3F, 0.7F, 0.3F, 0.4F}, scene::box({-9, -11, -9}, {18, 1, 18}))});
}

std::vector<View> views(const csg::Box& box) {
    base::Camera plain = scene::camera(box), flat = plain, inside;
    flat.projection = base::Projection::Orthographic;
    inside.target = box.center();
    inside.distance = 1e-3;
    return {{"perspective", plain, {200, 170}, 1, false},
            {"four samples", plain, {96, 96}, 4, false},
            {"orthographic, clear ground", flat, {150, 97}, 1, true},
            {"from inside", inside, {64, 64}, 1, false},
            {"one pixel", plain, {1, 1}, 4, false},
            {"one row", plain, {70, 1}, 1, false}};
}

using Ways = std::vector<std::pair<const npr::StyleInfo*, std::map<std::string, std::string>>>;

/// Each style as it is.
Ways plain_ways() {
    Ways list;
    for (const npr::StyleInfo& style : npr::styles()) {
        list.push_back({&style, {}});
    }
    return list;
}

/// Settings that change their ways.
Ways changed_ways() {
    Ways list;
    const auto add = [&](std::string_view style, std::map<std::string, std::string> settings) {
        list.push_back({npr::find_style(style), std::move(settings)});
    };
    add("edges", {{"width", "4"}, {"parts", "off"}, {"shade", "0.3"}});
    add("lines", {{"width", "3"}, {"ink", "#ffffff"}, {"paper", "#204060"}});
    add("gooch", {{"inner-color", "#000000"}, {"inner", "0.4"}, {"specular", "1"}, {"width", "3"}});
    add("toon", {{"steps", "6"}, {"highlight", "0"}});
    add("hatch", {{"tone", "1"}, {"color", "0.5"}, {"spacing", "6"}, {"crossed", "0.1"}});
    add("stipple", {{"tone", "1"}, {"spacing", "8"}, {"seed", "3"}});
    add("tech", {{"dashes", "on"}, {"opacity", "0.7"}});
    add("ntone", {{"steps", "7"}, {"cue", "1"}, {"shadows", "off"}});
    add("toon", {{"shadows", "on"}});
    add("gooch", {{"shadows", "on"}});
    add("blueprint", {{"grid", "on"}, {"ground", "white"}, {"layers", "2"}, {"width", "0.5"}});
    add("blueprint", {{"width", "3.3"}, {"crease", "4"}, {"inner", "0.3"}});
    add("blueprint", {{"dashes", "on"}, {"width", "2"}});
    add("blueprint", {{"halo", "3"}, {"taper", "0.7"}, {"taper-ends", "0.9"}});
    add("lines", {{"halo", "2"}, {"taper", "0.4"}, {"width", "2.5"}});
    add("xray", {{"dashes", "on"}});
    add("xray", {{"colors", "layers"}, {"rim", "0"}, {"layers", "3"}});
    add("xray", {{"colors", "none"}, {"opacity", "0.6"}, {"cue", "1"}, {"inner", "0.2"}});
    add("sketch", {{"hidden", "0.6"}, {"strokes", "4"}, {"width", "3"}, {"wobble", "9"}, {"color", "0.2"}});
    add("sketch", {{"medium", "ink"}, {"anchor", "model"}, {"seed", "7"}, {"overshoot", "60"}, {"hatch", "1"}});
    add("sketch", {{"medium", "chalk"}, {"paper", "#24342f"}, {"ink", "#f4f1e4"}, {"width", "0.5"}});
    return list;
}

Ways ways() {
    Ways list = plain_ways();
    const Ways more = changed_ways();
    list.insert(list.end(), more.begin(), more.end());
    return list;
}

npr::Picture picture(const npr::StyleInfo& style, const std::map<std::string, std::string>& settings,
                     const View& view) {
    npr::Picture result;
    result.draw_as(style);
    for (const auto& [name, value] : settings) {
        result.parameters.read(name, value);
    }
    result.scheme = *npr::find_color_scheme("DeepOcean");
    result.camera = view.camera;
    result.size = view.size;
    result.samples = view.samples;
    result.transparent_background = view.transparent_background;
    return result;
}

/// Share of pixels, for each of a pixel's samples, in which a decision at its threshold (is this a crease, do these
/// planes meet?) may go either way by rounding: each moves one piece of a line, which covers up to 25 pixels when it
/// is 3.3 wide. Five or six of the some thousand pieces in a picture of 150 x 97 pixels come to less than that.
constexpr double kTurned = 0.006;

class PaintTest : public test_support::GlTest {
  protected:
    /// `sections`: of each picture.
    void compare(Easel& easel, const Ways& ways, const std::vector<View>& views, const npr::Sections& sections = {});
};

/// Styles are made once, as programs do: compiling their shaders takes longer than drawing.
void PaintTest::compare(Easel& easel, const Ways& ways, const std::vector<View>& views, const npr::Sections& sections) {
    easel.darken_blocks();
    npr::Accumulator accumulator(gl());
    std::map<const npr::StyleInfo*, std::unique_ptr<npr::Style>> styles;
    for (const View& view : views) {
        for (const auto& [style, settings] : ways) {
            npr::Picture p = picture(*style, settings, view);
            p.sections = sections;
            std::unique_ptr<npr::Style>& made = styles[style];
            made = made ? std::move(made) : style->make(gl());
            const base::Image painted = easel.paint(p), drawn = easel.draw(gl(), accumulator, *made, p);
            ASSERT_EQ(painted.rgba.size(), drawn.rgba.size());
            EXPECT_LE(differing(painted, drawn, golden::tolerance(context_->renderer()).channel),
                      view.samples * kTurned * view.size.x * view.size.y)
                << style->name << ", " << view.name << ", settings: " << settings.size();
        }
    }
}

TEST_P(PaintTest, StylesAreWhatOpenGlDraws) {
    Easel easel(mixed());
    compare(easel, plain_ways(), views(easel.box()));
}

TEST_P(PaintTest, SettingsAreWhatOpenGlDraws) {
    Easel easel(mixed());
    compare(easel, changed_ways(), views(easel.box()));
}

TEST_P(PaintTest, CutFacesAreWhatOpenGlDraws) {
    // They are hatched, and lines about them are heavier.
    Easel easel(scene::combine(Operation::Difference, {mixed(), scene::box({0, -12, -12}, {12, 24, 24})}),
                Easel::LastLeaf::IsSection);
    const std::vector<View> all = views(easel.box());
    const npr::Sections sections{{{npr::PlaneSection{{1, 0, 0}, 0}, "plane"}}, {}, npr::Sections::kOwnSpacing};
    compare(easel, plain_ways(), {all[0], all[2]}, sections);
    npr::Picture cut = picture(*npr::find_style("edges"), {}, all[0]), uncut = cut;
    cut.sections = sections;
    EXPECT_GT(differing(easel.paint(cut), easel.paint(uncut), 8), 300) << "nothing is hatched";
}

TEST_P(PaintTest, AllModelsOfTransparencyAreWhatOpenGlDraws) {
    Easel easel(scene::combine(
        Operation::Union, {mixed(), scene::colored({0.2F, 0.4F, 0.9F, 0.7F}, scene::box({-4, -9, -12}, {9, 18, 30})),
                           scene::colored({0.2F, 0.4F, 0.9F, 0.7F}, scene::box({-9, -11, -9}, {18, 9, 9}))}));
    npr::Accumulator accumulator(gl());
    for (const char* name : {"shaded", "edges"}) {
        const npr::StyleInfo& style = *npr::find_style(name);
        const std::unique_ptr<npr::Style> made = style.make(gl());
        for (const npr::TransparencyInfo& transparency : npr::transparencies()) {
            for (const View& view : views(easel.box())) {
                npr::Picture p = picture(style, {}, view);
                p.transparency = transparency.model;
                EXPECT_LE(differing(easel.paint(p), easel.draw(gl(), accumulator, *made, p),
                                    golden::tolerance(context_->renderer()).channel),
                          view.samples * kTurned * view.size.x * view.size.y)
                    << transparency.name << ", " << name << ", " << view.name;
            }
        }
    }
}

TEST(Paint, TheSameBytesWithAnyNumberOfThreads) {
    Easel easel(mixed());
    const View view = views(easel.box())[0];
    for (const auto& [style, settings] : ways()) {
        const npr::Picture p = picture(*style, settings, view);
        const base::Image one = easel.paint(p, 1);
        EXPECT_EQ(differing(one, easel.paint(p, 3), 0), 0) << style->name;
        EXPECT_EQ(differing(one, easel.paint(p), 0), 0) << style->name;
    }
}

TEST(Paint, AKeptSketchIsPaintedAnewWhenTold) {
    // The noise is kept from picture to picture; another seed, size, view or model must not get the old one.
    Easel easel(mixed()), larger(scene::box({0, 0, 0}, {40, 40, 40}));
    const npr::StyleInfo& sketch = *npr::find_style("sketch");
    const npr::Paint kept = sketch.make_paint();
    for (const View& view : views(easel.box())) {
        for (const auto& settings : {std::map<std::string, std::string>{{"seed", "1"}},
                                     {{"seed", "2"}},
                                     {{"seed", "2"}, {"anchor", "model"}},
                                     {{"seed", "2"}, {"medium", "chalk"}},
                                     {{"seed", "1"}}}) {
            const npr::Picture p = picture(sketch, settings, view);
            for (Easel* each : {&easel, &larger}) {
                EXPECT_EQ(differing(each->paint(kept, p), each->paint(p), 0), 0) << view.name;
            }
        }
    }
}

TEST(Paint, ASceneOfNothingIsBackground) {
    Easel easel(scene::combine(Operation::Intersection,
                               {scene::box({0, 0, 0}, glm::dvec3(1)), scene::box({2, 0, 0}, glm::dvec3(1))}));
    for (const auto& [style, settings] : ways()) {
        const base::Image clear = easel.paint(picture(*style, settings, {"", base::Camera(), {40, 40}, 4, true}));
        EXPECT_EQ(*std::max_element(clear.rgba.begin(), clear.rgba.end()), 0) << style->name;
    }
}

TEST(SrgbTables, AreTheFormulasOfTheShaders) {
    const npr::SrgbTables& tables = npr::SrgbTables::get();
    const auto srgb = [](double c) { return c > 0.0031308 ? 1.055 * std::pow(c, 1 / 2.4) - 0.055 : 12.92 * c; };
    for (int i = 0; i <= 100'000; ++i) {
        const double c = i / 100'000.0;
        const double linear = c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92;
        ASSERT_NEAR(tables.linear(static_cast<float>(c)), linear, 2e-7) << c;
        ASSERT_NEAR(tables.byte(static_cast<float>(c)), 255 * srgb(c), 0.501) << c;
    }
    EXPECT_EQ(tables.byte(-1), 0);
    EXPECT_EQ(tables.byte(2), 255);
}

INSTANTIATE_TEST_SUITE_P(Contexts, PaintTest, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

}  // namespace
