// Labels: where they are, over the gallery from many sides.
#include "ui/pipeline/annotation/annotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/csg/scad/evaluate_text.h"
#include "ui/pipeline/annotation/callouts.h"
#include "ui/pipeline/annotation/glyph_painter.h"
#include "ui/pipeline/annotation/screen_plane.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {
namespace {

std::shared_ptr<const Model> model_of(const std::string& text) {
    ModelBuilder builder;
    csg::PartRule rule;
    rule.kind = csg::PartRule::Kind::Depth;
    builder.divide(rule);
    return builder.build(test::run(text).evaluation.tree);
}

struct Viewed {
    Viewed(const Model& of, const base::Camera& camera, glm::ivec2 size)
        : model(of), view(camera, size, of.geometry.box.lo, of.geometry.box.hi), renderer({}, Painter::Cpu) {}

    Annotated annotated(const Annotations& annotations) {
        return annotate(
            model, view, [&](int layers) { return renderer.first_layers(model, view, layers); }, annotations,
            glm::vec3(1));
    }

    const Model& model;
    base::View view;
    Renderer renderer;
};

base::Camera camera_of(const Model& model, double x, double z, base::Projection projection) {
    base::Camera camera;
    camera.rotation = {x, 0, z};
    camera.projection = projection;
    base::view_all(camera, model.box.lo, model.box.hi, true);
    return camera;
}

/// All glyphs of the last part, in the picture.
void expect_within(const Annotated& made, const base::View& view) {
    const csg::Part& part = made.model->scene.parts.back();
    std::size_t texts = 0;
    for (csg::LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
        PixelBox box{glm::dvec2(1e9), glm::dvec2(-1e9)};
        for (const glm::dvec3& p : made.model->geometry.leaves[leaf].points) {
            const SeenAt seen = seen_at(view, p);
            box.lo = glm::min(box.lo, seen.pixel);
            box.hi = glm::max(box.hi, seen.pixel);
        }
        for (const PlacedText& text : made.texts) {
            const PixelBox wide = text.place.box.grown(0.5);
            const bool within =
                box.lo.x >= wide.lo.x && box.lo.y >= wide.lo.y && box.hi.x <= wide.hi.x && box.hi.y <= wide.hi.y;
            texts += within ? 1 : 0;
        }
    }
    EXPECT_GE(texts, made.texts.size()) << "each text is in its box";
}

/// What holds of labels in every picture.
void expect_readable(const Annotated& made, Viewed& viewed) {
    const auto all = viewed.renderer.first_layers(viewed.model, viewed.view, 0);
    for (std::size_t i = 0; i < made.texts.size(); ++i) {
        const PlacedText& text = made.texts[i];
        EXPECT_EQ(text.place.of_model, 0) << text.text << " covers the model";
        EXPECT_GE(text.place.box.lo.x, 0);
        EXPECT_GE(text.place.box.lo.y, 0);
        EXPECT_LE(text.place.box.hi.x, viewed.view.size().x);
        EXPECT_LE(text.place.box.hi.y, viewed.view.size().y);
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_FALSE(overlap(text.place.box, made.texts[k].place.box)) << text.text << ", " << made.texts[k].text;
        }
        if (!text.part) {
            continue;
        }
        // In that layer of the pixel the part is to be seen, and in none before it.
        for (int layer = 0; layer <= text.part->layer; ++layer) {
            const layers::Surface surface = all->at(layer, text.part->pixel.x, text.part->pixel.y);
            ASSERT_GT(surface.depth, 0);
            const csg::PartId part = viewed.model.scene.leaves[surface.leaf].part;
            EXPECT_EQ(std::count(text.parts.begin(), text.parts.end(), part) > 0, layer == text.part->layer);
        }
        const SeenAt seen = seen_at(viewed.view, text.part->point);
        EXPECT_LT(glm::distance(seen.pixel, text.anchor), 0.01);
        EXPECT_LT(glm::distance(text.anchor, glm::dvec2(text.part->pixel) + 0.5), 1);
    }
    expect_within(made, viewed.view);
}

class OverTheGallery : public testing::TestWithParam<const char*> {};

/// Ten views of each of five models.
TEST_P(OverTheGallery, LabelsAreReadable) {
    ModelBuilder builder;
    csg::PartRule rule;
    rule.kind = csg::PartRule::Kind::Depth;
    builder.divide(rule);
    csg::scad::Request request;
    request.path = std::string(CSGSCOPE_SOURCE_DIR "/models/") + GetParam() + ".scad";
    const auto run = csg::scad::evaluate(request, {});
    ASSERT_NE(run.tree, nullptr);
    const auto model = builder.build(run.tree);
    int number = 0;
    for (const double x : {15.0, 50.0, 80.0, 110.0, 160.0}) {
        for (const double z : {20.0, 200.0}) {
            Viewed viewed(*model,
                          camera_of(*model, x, z + 7 * number,
                                    number % 3 == 0 ? base::Projection::Orthographic : base::Projection::Perspective),
                          number % 2 == 0 ? glm::ivec2(512, 512) : glm::ivec2(640, 480));
            ++number;
            Annotations annotations;
            annotations.callouts = true;
            LabelRequest label;
            label.of.name = model->scene.parts.front().name;
            label.text = "The first of them\nin two lines";
            annotations.labels.push_back(label);
            SCOPED_TRACE(number);
            const Annotated made = viewed.annotated(annotations);
            EXPECT_GE(made.texts.size(), 2u);
            expect_readable(made, viewed);
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Annotation, OverTheGallery, testing::Values("padlock", "gears", "box", "pipe_tee", "spanner"));

constexpr const char* kTwo =
    "module base() cube([40, 40, 4]); module pin() cylinder(h = 20, r = 2); module core() sphere(1);\n"
    "base(); translate([10, 10, 4]) pin(); translate([30, 30, 4]) pin(); translate([20, 20, 2]) core();";

TEST(Annotation, LeadersOfWhatIsHiddenRunThroughTheScene) {
    const auto model = model_of(kTwo);
    Viewed viewed(*model, camera_of(*model, 50, 20, base::Projection::Perspective), {400, 400});
    Annotations annotations;
    for (const char* const name : {"core", "pin"}) {
        LabelRequest label;
        label.of.name = name;
        label.text = name;
        annotations.labels.push_back(label);
    }
    const Annotated made = viewed.annotated(annotations);
    ASSERT_EQ(made.texts.size(), 2u);
    EXPECT_GT(made.texts[0].part->layer, 0);
    EXPECT_LT(glm::distance(made.texts[0].part->point, glm::dvec3(20, 20, 2)), 1.01);
    EXPECT_EQ(made.texts[1].part->layer, 0);
    EXPECT_EQ(made.texts[1].parts.size(), 2u) << "a name means all that differ by a number";
    // The glyphs are a part of their own, before all others but for the line to what is hidden.
    EXPECT_EQ(made.model->scene.parts.back().name, "labels");
    EXPECT_EQ(made.model->scene.parts.size(), model->scene.parts.size() + 1);
    const csg::Part& part = made.model->scene.parts.back();
    double farthest = 0;
    for (csg::LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
        for (const glm::dvec3& p : made.model->geometry.leaves[leaf].points) {
            farthest = std::max(farthest, seen_at(viewed.view, p).distance);
        }
    }
    EXPECT_NEAR(farthest, seen_at(viewed.view, made.texts[0].part->point).distance, 1);
}

TEST(Annotation, NamesThatAreNone) {
    const auto model = model_of(kTwo);
    Viewed viewed(*model, camera_of(*model, 50, 20, base::Projection::Perspective), {200, 200});
    Annotations annotations;
    LabelRequest label;
    label.of.name = "pinn";
    label.text = "?";
    annotations.labels.push_back(label);
    try {
        (void)viewed.annotated(annotations);
        ADD_FAILURE();
    } catch (const ModelError& error) {
        EXPECT_NE(std::string(error.what()).find("Did you mean \"pin\"?"), std::string::npos) << error.what();
    }
    // What is not in the picture has no label.
    annotations.labels[0].of.name = "pin 2";
    Viewed away(*model, base::camera_between({10, 10, 60}, {10, 10, 0}), {20, 20});
    EXPECT_EQ(away.annotated(annotations).unseen, (std::vector<std::size_t>{0}));
    // More text than there is room for.
    annotations.labels[0].text = std::string(400, 'W');
    EXPECT_THROW((void)viewed.annotated(annotations), ModelError);
}

TEST(Annotation, TheSameGivesTheSame) {
    const auto model = model_of(kTwo);
    Viewed viewed(*model, camera_of(*model, 50, 20, base::Projection::Perspective), {300, 300});
    Annotations annotations;
    annotations.callouts = true;
    const Annotated one = viewed.annotated(annotations), other = viewed.annotated(annotations);
    ASSERT_EQ(one.texts.size(), 4u);  // Base, pins, core; and the legend.
    EXPECT_EQ(one.texts.back().text, "1   base\n2   pin ×2\n3   core");
    for (std::size_t i = 0; i < one.texts.size(); ++i) {
        EXPECT_EQ(one.texts[i].place.box.lo, other.texts[i].place.box.lo);
    }
}

TEST(Annotation, BubblesFramesAndArrows) {
    const auto model = model_of(kTwo);
    Viewed viewed(*model, camera_of(*model, 60, 20, base::Projection::Orthographic), {400, 400});
    Annotations annotations;
    annotations.bubbles.push_back({{30, 30, 24}, "This is what the second of the pins has to say", {}});
    annotations.frames.push_back({{{8, 8, 4}, {12, 12, 24}}, "a pin", {}, {}});
    annotations.arrows.push_back({{{0, 0, 30}, {20, 0, 40}, {40, 0, 30}}, 1.0, {}});
    const Annotated made = viewed.annotated(annotations);
    ASSERT_EQ(made.texts.size(), 2u);
    EXPECT_EQ(std::count(made.texts[0].text.begin(), made.texts[0].text.end(), '\n'), 2);
    EXPECT_FALSE(overlap(made.texts[0].place.box, made.texts[1].place.box));
    expect_within(made, viewed.view);
    // A smooth curve goes through its points.
    const std::vector<glm::dvec3> curve = smooth_curve(annotations.arrows[0].points);
    EXPECT_EQ(curve[16], glm::dvec3(20, 0, 40));
    EXPECT_EQ(curve.back(), glm::dvec3(40, 0, 30));
    EXPECT_GT(curve[8].z, 35);
}

TEST(LabelLayout, GoesBesideWhatIsThere) {
    layers::HostStack stack;
    stack.resize({100, 100});
    stack.reserve(1);
    stack.layers = 1;
    for (std::size_t y = 30; y < 70; ++y) {
        for (std::size_t x = 30; x < 70; ++x) {
            stack.planes[0].depth[y * 100 + x] = 0.5F;
            stack.planes[0].surface[y * 100 + x] = {0, 0};
        }
    }
    const Coverage coverage(stack);
    EXPECT_EQ(coverage.pixels({{0, 0}, {100, 100}}), 1600);
    EXPECT_EQ(coverage.pixels({{0, 0}, {31, 32}}), 2);
    std::vector<LabelBox> labels(6, {{24, 9}, {50, 50}, true});
    const auto placed = lay_out(coverage, labels);
    ASSERT_TRUE(placed.has_value());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_EQ((*placed)[i].of_model, 0);
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_FALSE(overlap((*placed)[i].box, (*placed)[k].box));
        }
    }
    // Only where there is no other room it is over the model.
    const auto large = lay_out(coverage, std::vector<LabelBox>{{{90, 40}, {50, 50}, true}});
    ASSERT_TRUE(large.has_value());
    EXPECT_GT((*large)[0].of_model, 0);
    EXPECT_FALSE(lay_out(coverage, std::vector<LabelBox>{{{99, 40}, {50, 50}, true}}).has_value());
}

}  // namespace
}  // namespace ui
