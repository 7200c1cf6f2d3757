// The linear form of expressions against the expressions themselves.
#include "goldfeather/blist.h"

#include <gtest/gtest.h>

#include <random>

#include "csg/solid/part_order.h"
#include "goldfeather/lists_cpu/expression_state.h"
#include "tests/random/build_model.h"

namespace {

using csg::solid::part_order;
using goldfeather::Blist;

csg::Scene random_scene(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const bool large = seed % 8 == 0;
    return csg::make_scene(random_tree::make_tree(random_tree::make_model(random, {large ? 60 : 14, 6, true})));
}

TEST(Blist, HasTheValueOfTheExpression) {
    std::size_t both[2] = {0, 0};
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        const csg::Scene scene = random_scene(seed);
        const Blist blist(scene, part_order(scene, nullptr));
        std::mt19937_64 random(seed);
        std::vector<char> values;
        for (int sample = 0; sample < 40; ++sample) {
            std::vector<csg::LeafId> inside;
            for (csg::LeafId leaf = 0; leaf < scene.leaves.size(); ++leaf) {
                if (random() % 4 >= static_cast<unsigned>(sample % 4)) {
                    inside.push_back(leaf);
                }
            }
            std::shuffle(inside.begin(), inside.end(), random);  // Their order does not matter.
            for (std::uint32_t rank = 0; rank < blist.parts().size(); ++rank) {
                const auto holds = [&](csg::LeafId leaf) {
                    return std::find(inside.begin(), inside.end(), leaf) != inside.end();
                };
                const bool expected = csg::evaluate(scene, scene.parts[blist.parts()[rank]], holds, values);
                ASSERT_EQ(blist.value(rank, inside), expected) << "seed " << seed;
                ++both[expected ? 1 : 0];
            }
        }
    }
    EXPECT_GT(both[0], 1000U);
    EXPECT_GT(both[1], 1000U);
}

TEST(Blist, KnowsWhoIsResponsible) {
    std::size_t both[2] = {0, 0};
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        const csg::Scene scene = random_scene(seed);
        const Blist blist(scene, part_order(scene, nullptr));
        const goldfeather::ExpressionTree tree(scene);
        goldfeather::ExpressionState state(tree);
        std::mt19937_64 random(seed);
        for (int step = 0; step < 60; ++step) {
            if (scene.leaves.empty()) {
                break;
            }
            state.toggle(static_cast<csg::LeafId>(random() % scene.leaves.size()));
            std::vector<csg::LeafId> inside;
            for (csg::LeafId leaf = 0; leaf < scene.leaves.size(); ++leaf) {
                if (state.inside_leaf(leaf)) {
                    inside.push_back(leaf);
                }
            }
            for (csg::LeafId leaf = 0; leaf < scene.leaves.size(); ++leaf) {
                const std::uint32_t rank = blist.leaves()[leaf].rank;
                ASSERT_EQ(blist.value(rank, inside), state.inside_part(blist.parts()[rank]));
                if (!blist.value(rank, inside)) {
                    continue;  // Asked only on the result's side.
                }
                if (blist.leaves()[leaf].first == Blist::kNone) {
                    ASSERT_FALSE(blist.responsible(leaf, inside));  // No result depends on it.
                    continue;
                }
                ASSERT_EQ(blist.responsible(leaf, inside), state.responsible(leaf)) << "seed " << seed;
                ++both[state.responsible(leaf) ? 1 : 0];
            }
        }
    }
    EXPECT_GT(both[0], 1000U);
    EXPECT_GT(both[1], 1000U);
}

/// Nothing recurses on what a user wrote, and a chain of alternations is evaluated in steps of leaves that hold.
TEST(Blist, TakesAnyDepth) {
    using random_tree::combine;
    random_tree::Model nested = random_tree::box({0, 0, 0}, {1, 1, 1});
    for (int i = 0; i < 400; ++i) {
        const auto operation = i % 2 == 0 ? csg::Operation::Difference : csg::Operation::Union;
        nested = combine(operation, {random_tree::box({0, 0, 0}, {1, 1, 1}), std::move(nested)});
    }
    const csg::Scene scene = csg::make_scene(random_tree::make_tree(nested));
    const Blist blist(scene, part_order(scene, nullptr));
    std::vector<char> values;
    for (csg::LeafId inside = 0; inside < scene.leaves.size(); ++inside) {
        const auto holds = [&](csg::LeafId leaf) { return leaf == inside; };
        ASSERT_EQ(blist.value(0, {&inside, 1}), csg::evaluate(scene, scene.parts[0], holds, values));
    }
}

TEST(Blist, KeepsTheOrderOfParts) {
    auto a = random_tree::box({0, 0, 0}, {1, 1, 1}), b = a;
    b.modifiers.highlight = true;
    const csg::Scene scene =
        csg::make_scene(random_tree::make_tree(random_tree::combine(csg::Operation::Union, {a, b})));
    const Blist blist(scene, {1, 0});
    ASSERT_EQ(scene.parts.size(), 2U);
    EXPECT_EQ(blist.parts(), (std::vector<csg::PartId>{1, 0}));
    EXPECT_EQ(blist.leaves()[0].rank, 1U);
}

}  // namespace
