// Pairs of boxes from the tree are those that each with each gives.
#include "csg/reference/box_pairs.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

TEST(BoxPairs, AreThoseOfEachWithEach) {
    std::mt19937 random(7);
    // Whole numbers, so that many boxes touch in a face, an edge or a corner.
    std::uniform_int_distribution<int> place(0, 20), length(0, 4);
    for (const std::size_t count : {0u, 1u, 2u, 8u, 9u, 17u, 300u}) {
        std::vector<csg::Box> boxes;
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 lo(place(random), place(random), place(random));
            boxes.push_back({lo, lo + glm::dvec3(length(random), length(random), length(random))});
        }
        Pairs found, expected;
        csg::reference::BoxTree(boxes).pairs([&](std::uint32_t a, std::uint32_t b) {
            EXPECT_TRUE(found.emplace(std::min(a, b), std::max(a, b)).second) << "twice";
        });
        for (std::uint32_t a = 0; a < count; ++a) {
            for (std::uint32_t b = a + 1; b < count; ++b) {
                const glm::dvec3 lo = glm::max(boxes[a].lo, boxes[b].lo), hi = glm::min(boxes[a].hi, boxes[b].hi);
                if (lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z) {
                    expected.emplace(a, b);
                }
            }
        }
        EXPECT_EQ(found, expected) << count;
    }
}

}  // namespace
