// Where faces of several parts coincide one of them is seen, by every engine, whatever the order of parts in the text.
#include "csg/solid/part_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/goldfeather/engine_test.h"
#include "tests/random/build_model.h"

namespace {

using comparison::Subject;
using random_tree::box;
using random_tree::combine;
using random_tree::Model;

Model colored(const csg::Rgba& color, Model model) {
    Model result = combine(csg::Operation::Color, {std::move(model)});
    result.color = color;
    return result;
}

/// All have a face in z = 4, and lie over each other.
std::vector<Model> parts() {
    const Model a = box({-6, -6, 0}, {9, 9, 4}), b = box({-4, -5, 1}, {9, 9, 3});
    Model marked = box({-1, -1, 2}, {3, 3, 2});
    marked.modifiers.highlight = true;
    Model ghost = box({-7, -7, 3}, {5, 5, 1});
    ghost.modifiers.background = true;
    return {colored({0.2F, 0.9F, 0.9F, 1}, a),
            colored({0.8F, 0.1F, 0.1F, 1}, b),
            colored({0.9F, 0.9F, 0.9F, 0.5F}, box({-2, -8, 0}, {4, 12, 4})),
            box({0, -8, 2}, {7, 7, 2}),
            combine(csg::Operation::Difference, {box({1, -7, 1}, {7, 12, 5}), box({0, -9, 4}, {9, 20, 9})}),
            ghost,
            marked};
}

/// What is left of a leaf when its number is forgotten: colors, corners and the part's kind.
std::string look_of(const Subject& subject, const layers::Surface& s) {
    const csg::LeafInstance& leaf = subject.scene.leaves[s.leaf];
    std::string text = std::to_string(static_cast<int>(subject.scene.parts[leaf.part].kind)) +
                       (s.reversed ? " cut " : " ") + (s.leaving ? "back " : "front ");
    const csg::Box& extent = subject.geometry.leaves[s.leaf].box;
    for (const double value : {static_cast<double>(leaf.color.r), extent.lo.x, extent.lo.y, extent.lo.z, extent.hi.x}) {
        text += std::to_string(value) + " ";
    }
    return text;
}

class PartOrder : public comparison::EngineTest {
  protected:
    [[nodiscard]] std::vector<std::string> looks(const std::vector<Model>& models) {
        csg::PartRule rule;
        rule.kind = csg::PartRule::Kind::Depth;
        const Subject subject(random_tree::make_tree(combine(csg::Operation::Union, models)), true, rule);
        base::Camera camera;
        camera.target = {0, 0, 2};
        camera.rotation = {0, 0, 0};
        camera.distance = 60;
        const layers::HostStack stack = engine().peel(subject, subject.view(camera, {24, 24}));
        std::vector<std::string> result;
        for (int y = 0; y < 24; ++y) {
            for (int x = 0; x < 24; ++x) {
                for (int layer = 0; layer < stack.layers && stack.at(layer, x, y).depth > 0; ++layer) {
                    result.push_back(look_of(subject, stack.at(layer, x, y)));
                }
            }
        }
        return result;
    }
};

TEST_P(PartOrder, IsThatOfTheTextInNoCase) {
    std::vector<Model> models = parts();
    const std::vector<std::string> expected = looks(models);
    std::mt19937 random(4);
    for (int trial = 0; trial < 6; ++trial) {
        std::shuffle(models.begin(), models.end(), random);
        EXPECT_EQ(looks(models), expected) << trial;
    }
    // Alike but for where they are.
    const Model cube = box({-3, -3, 0}, {5, 5, 4}), moved = random_tree::at({1, 2, 0}, cube);
    EXPECT_EQ(looks({cube, moved}), looks({moved, cube}));
}

TEST(PartOrderOfAScene, IsByKindOpacityAndColor) {
    std::vector<Model> models = parts();
    csg::PartRule rule;
    rule.kind = csg::PartRule::Kind::Depth;
    const Subject subject(random_tree::make_tree(combine(csg::Operation::Union, models)), false, rule);
    const std::vector<csg::PartId> order = csg::solid::part_order(subject.scene, &subject.geometry);
    std::vector<csg::PartKind> kinds;
    std::vector<float> reds;
    for (const csg::PartId part : order) {
        kinds.push_back(subject.scene.parts[part].kind);
        reds.push_back(subject.scene.parts[part].color.r);
    }
    using enum csg::PartKind;
    EXPECT_EQ(kinds, (std::vector{Highlight, Solid, Solid, Solid, Solid, Translucent, Background}));
    EXPECT_FLOAT_EQ(reds[1], 0.8F);
    EXPECT_FLOAT_EQ(reds[2], 0.2F);
    const std::vector<std::uint32_t> ranks = csg::solid::ranks_of(order);
    for (std::uint32_t rank = 0; rank < order.size(); ++rank) {
        EXPECT_EQ(ranks[order[rank]], rank);
    }
}

INSTANTIATE_TEST_SUITE_P(Engines, PartOrder, testing::ValuesIn(comparison::engine_names({gl::ContextKind::Osmesa})),
                         comparison::engine_name);

}  // namespace
