// Models edited in place: what renderers show of them.
#include "ui/pipeline/editable_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/random/build_model.h"
#include "tests/support/gl_test.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {
namespace {

std::shared_ptr<const Model> row_of_holes() {
    std::vector<random_tree::Model> all{random_tree::box({0, 0, 0}, {20, 4, 2})};
    for (int i = 0; i < 9; ++i) {
        all.push_back(random_tree::box({2.0 * i + 1, 1, -1}, {1, 2, 4}));
    }
    return ModelBuilder().build(std::make_shared<const csg::Tree>(
        random_tree::make_tree(random_tree::combine(csg::Operation::Difference, all))));
}

class EditableModels : public testing::TestWithParam<const goldfeather::EngineInfo*> {
  protected:
    [[nodiscard]] std::unique_ptr<Renderer> renderer() {
        if (!GetParam()->capabilities.needs_opengl) {
            return std::make_unique<Renderer>(GetParam(), Painter::Cpu);
        }
        if (!context_) {
            auto made = test_support::try_context(gl::ContextKind::Egl);
            if (!made.context) {
                test_support::skip_or_fail("no OpenGL: " + made.reason);
                return nullptr;
            }
            context_ = std::move(made.context);
        }
        return std::make_unique<Renderer>(*context_, GetParam(), Painter::OpenGl);
    }
    std::unique_ptr<gl::Context> context_;
};

/// One renderer that is told of every change, and a new one for every picture.
TEST_P(EditableModels, AreDrawnAsTheyAreNow) {
    const auto model = row_of_holes();
    EditableModel edited(*model);
    const auto told = renderer();
    if (!told) {
        return;
    }
    PictureRequest request;
    request.size = {48, 48};
    request.samples = 1;
    base::view_all(request.camera, model->box.lo, model->box.hi, true);
    const base::Image first = told->render(edited.model(), request);
    base::Image before = first;
    const glm::dmat4 rest = edited.model().scene.leaves[4].to_world;
    csg::solid::AddedId section = 0;
    const std::array<std::function<void(csg::solid::EditableScene&)>, 6> edits{
        [&](auto& scene) {
            scene.move(4, glm::translate(rest, {0.3, 0.5, 0.1}));
        },
        [&](auto& scene) {
            scene.move(4, glm::translate(rest, {0, 100, 0}));
        },
        [&](auto& scene) {
            section = scene.add({0}, csg::ExpressionKind::Intersection, {{0.6, 0, 0.8}, 8}, {1, 0, 0, 1});
        },
        [&](auto& scene) {
            scene.move(section, csg::solid::Plane{{0.6, 0, 0.8}, 6});
        },
        [&](auto& scene) { scene.move_part(0, glm::rotate(glm::dmat4(1.0), 0.2, glm::dvec3(1, 1, 1))); },
        [&](auto& scene) { scene.show(0, false); },
    };
    for (std::size_t i = 0; i < edits.size(); ++i) {
        edits[i](edited.scene());
        told->update(edited.model(), edited.commit());
        const base::Image image = told->render(edited.model(), request);
        EXPECT_EQ(image.rgba, renderer()->render(edited.model(), request).rgba) << "edit " << i;
        EXPECT_NE(image.rgba, before.rgba) << "edit " << i << " shows";
        before = image;
    }
    edited.scene().show(0, true);
    edited.scene().move_part(0, glm::dmat4(1.0));
    edited.scene().remove(section);
    edited.scene().move(4, rest);
    told->update(edited.model(), edited.commit());
    EXPECT_EQ(told->render(edited.model(), request).rgba, first.rgba);
    EXPECT_EQ(told->render(*model, request).rgba, first.rgba);
}

TEST_P(EditableModels, KeepTheirSmoothSurfaces) {
    csg::Fineness fine;
    fine.fn = 24;
    const auto model = ModelBuilder().build(std::make_shared<const csg::Tree>(random_tree::make_tree(
        random_tree::combine(csg::Operation::Union, {random_tree::leaf(csg::Cylinder{20, 8, 8, true, fine}),
                                                     random_tree::box({10, 0, 0}, {4, 4, 4})}))));
    EditableModel edited(*model);
    const auto told = renderer();
    if (!told) {
        return;
    }
    PictureRequest request;
    request.draw_as(*npr::find_style("gooch"));
    request.size = {64, 64};
    request.samples = 1;
    base::view_all(request.camera, model->box.lo, model->box.hi, true);
    const base::Image first = told->render(edited.model(), request);
    request.parameters.read("smooth", "off");
    EXPECT_NE(told->render(edited.model(), request).rgba, first.rgba);
    request.parameters.read("smooth", "on");
    edited.scene().move(0, glm::rotate(glm::dmat4(1.0), 0.4, glm::dvec3(1, 2, 0)));
    told->update(edited.model(), edited.commit());
    EXPECT_EQ(told->render(edited.model(), request).rgba, renderer()->render(edited.model(), request).rgba);
}

TEST(EditableModel, KeepsProductsTrue) {
    const auto model = row_of_holes();
    EditableModel edited(*model);
    ASSERT_EQ(edited.model().products[0][0].literals.size(), 10U);
    const glm::dmat4 rest = edited.model().scene.leaves[4].to_world;
    edited.scene().move(4, glm::translate(rest, {0, 100, 0}));
    EXPECT_FALSE(edited.commit().structure);
    EXPECT_EQ(edited.model().products[0][0].literals.size(), 9U) << "it touches nothing there";
    edited.scene().move(0, glm::translate(edited.model().scene.leaves[0].to_world, {0, 0, 1}));
    (void)edited.commit();
    EXPECT_EQ(edited.model().box, (csg::Box{{0, 0, 1}, {20, 4, 3}}));
    EXPECT_EQ(model->box, (csg::Box{{0, 0, 0}, {20, 4, 2}})) << "the model itself is as it was";
}

INSTANTIATE_TEST_SUITE_P(, EditableModels,
                         testing::Values(goldfeather::find_engine("lists-cpu"), goldfeather::find_engine("lists"),
                                         goldfeather::find_engine("goldfeather")),
                         [](const auto& info) {
                             std::string name(info.param->name);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace ui
