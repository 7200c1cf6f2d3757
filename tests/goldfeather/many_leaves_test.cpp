// Thousands of leaves at one depth: right, and at a cost that grows with their number only.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <random>

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "tests/goldfeather/comparison.h"
#include "tests/random/build_model.h"
#include "tests/support/sanitizer.h"

namespace {

using csg::Operation;
using random_tree::Model;

double cpu_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// So many equal boxes.
Model equal(int count) {
    std::vector<Model> boxes;
    for (int i = 0; i < count; ++i) {
        boxes.push_back(random_tree::box({0, 0, 0}, glm::dvec3(10)));
    }
    return random_tree::combine(Operation::Union, std::move(boxes));
}

/// A box less (a box less (…)), all with common walls, so that each event turns the whole chain.
Model chain(int count) {
    Model model = random_tree::box({0, 0, 0}, glm::dvec3(10));
    for (int i = 1; i < count; ++i) {
        std::vector<Model> children;
        children.push_back(random_tree::box({0, 0, 0}, {10, 10, 10 + i % 3}));
        children.push_back(std::move(model));
        model = random_tree::combine(Operation::Difference, std::move(children));
    }
    return model;
}

/// Seconds of one thread for a picture, the least of three.
double cost(const Model& model) {
    const comparison::Subject subject(random_tree::make_tree(model), false);
    base::Camera camera;
    base::view_all(camera, subject.geometry.box.lo, subject.geometry.box.hi, true);
    const base::View view = subject.view(camera, {32, 32});
    double least = 1e30;
    for (int i = 0; i < 3; ++i) {
        const double start = cpu_seconds();
        EXPECT_GT(goldfeather::peel_to_host(subject.scene, subject.geometry, view, 0, 1).layers, 0);
        least = std::min(least, cpu_seconds() - start);
    }
    return least;
}

TEST(ManyLeaves, AtOneDepthCostGrowsWithTheirNumber) {
    if (test_support::kAddressSanitizer) {
        GTEST_SKIP() << "costs are not those of the program with sanitizers";
    }
    for (const auto& family : {equal, chain}) {
        // Four times as many take four times as long, and sixteen times where each looks at all others. Both are more
        // than the nearest cache holds, which would make the fewer quicker than their number.
        EXPECT_LT(cost(family(12000)), 9 * cost(family(3000)));
    }
}

TEST(ManyLeaves, ManyAtOnceAreAsOneByOne) {
    std::mt19937_64 random(7);
    std::size_t changes = 0;
    for (int round = 0; round < 200; ++round) {
        const comparison::Subject subject(random_tree::make_tree(random_tree::make_model(random)), false);
        const goldfeather::ExpressionTree tree(subject.scene);
        goldfeather::ExpressionState batch(tree), single(tree);
        const auto leaves = static_cast<csg::LeafId>(subject.scene.leaves.size());
        for (int step = 0; leaves > 0 && step < 20; ++step) {
            std::vector<csg::LeafId> some(random() % 12);
            for (csg::LeafId& leaf : some) {
                leaf = static_cast<csg::LeafId>(random() % leaves);  // Some more than once.
            }
            std::vector<csg::PartId> changed, expected;
            for (csg::PartId part = 0; part < subject.scene.parts.size(); ++part) {
                if (single.inside_part(part)) {
                    expected.push_back(part);
                }
            }
            batch.toggle(some, changed);
            for (const csg::LeafId leaf : some) {
                (void)single.toggle(leaf);
            }
            for (csg::PartId part = 0; part < subject.scene.parts.size(); ++part) {
                ASSERT_EQ(batch.inside_part(part), single.inside_part(part));
                const bool before = std::find(expected.begin(), expected.end(), part) != expected.end();
                ASSERT_EQ(std::count(changed.begin(), changed.end(), part), before != single.inside_part(part) ? 1 : 0);
            }
            for (csg::LeafId leaf = 0; leaf < leaves; ++leaf) {
                ASSERT_EQ(batch.inside_leaf(leaf), single.inside_leaf(leaf));
                ASSERT_EQ(batch.responsible(leaf), single.responsible(leaf));
            }
            changes += changed.size();
        }
    }
    EXPECT_GT(changes, 100U);
}

}  // namespace
