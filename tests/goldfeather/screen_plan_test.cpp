#include "goldfeather/goldfeather/screen_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

using goldfeather::Literal;
using goldfeather::Product;
using goldfeather::ScreenPlan;

/// A view from above, one world unit a pixel or so.
base::View from_above(const csg::Box& box) {
    base::Camera camera;
    camera.rotation = {0, 0, 0};
    camera.projection = base::Projection::Orthographic;
    base::view_all(camera, box.lo, box.hi, true);
    return {camera, {400, 400}, box.lo, box.hi};
}

csg::Box box_of(const std::vector<csg::Box>& boxes) {
    csg::Box all;
    for (const csg::Box& b : boxes) {
        all = csg::enclose(all, b);
    }
    return all;
}

TEST(ScreenPlan, HolesOfAPlateShareSlots) {
    std::vector<csg::Box> boxes{{{0, 0, 0}, {500, 400, 5}}};
    Product plate{{{0, false}}, boxes[0]};
    for (int i = 0; i < 500; ++i) {
        const double x = 20.0 * (i % 25), y = 20.0 * (i / 25);
        boxes.push_back({{x + 5, y + 5, -1}, {x + 15, y + 15, 6}});
        plate.literals.push_back({static_cast<csg::LeafId>(i + 1), true});
    }
    const base::View view = from_above(box_of(boxes));
    const ScreenPlan plan = goldfeather::plan(view, std::vector{plate}, boxes);
    EXPECT_EQ(plan.leaves.size(), 501U);
    EXPECT_LE(plan.slots, 5U);
    EXPECT_EQ(plan.entries.size(), 1U);
}

TEST(ScreenPlan, WhatIsNotInTheViewIsNotPlanned) {
    const std::vector<csg::Box> boxes{{{0, 0, 0}, {10, 10, 10}}, {{1000, 0, 0}, {1010, 10, 10}}};
    const std::vector<Product> products{{{{0, false}}, boxes[0]}, {{{1, false}}, boxes[1]}};
    const base::View view = from_above(boxes[0]);
    const ScreenPlan plan = goldfeather::plan(view, products, boxes);
    ASSERT_EQ(plan.leaves.size(), 1U);
    EXPECT_EQ(plan.leaves[0].leaf, 0U);
    EXPECT_EQ(plan.products.size(), 1U);
}

/// The plan must answer as the products do, at every pixel and for every set of leaves that can be there.
TEST(ScreenPlan, EntriesMeanTheProducts) {
    std::mt19937 random(7);
    const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    for (int round = 0; round < 60; ++round) {
        std::vector<csg::Box> boxes;
        for (int i = 0; i < 14; ++i) {
            const glm::dvec3 lo(pick(300), pick(300), pick(50));
            boxes.push_back({lo, lo + glm::dvec3(10 + pick(90), 10 + pick(90), 10 + pick(40))});
        }
        std::vector<Product> products;
        for (int i = 0; i < 7; ++i) {
            Product p;
            for (csg::LeafId leaf = 0; leaf < boxes.size(); ++leaf) {
                if (pick(4) == 0) {
                    p.literals.push_back({leaf, !p.literals.empty() && pick(2) == 0});
                }
            }
            if (p.literals.empty()) {
                continue;
            }
            p.box = boxes[p.literals[0].leaf];
            for (const Literal& l : p.literals) {
                if (!l.complement) {
                    p.box = csg::intersect(p.box, boxes[l.leaf]);
                }
            }
            if (!p.box.empty()) {
                products.push_back(p);
            }
        }
        const base::View view = from_above(box_of(boxes));
        // Every third round some of the leaves have winding numbers: a word that is not zero is a full mask.
        std::vector<char> wound(boxes.size());
        for (char& leaf : wound) {
            leaf = round % 3 == 0 && pick(2) == 0;
        }
        const ScreenPlan plan = goldfeather::plan(view, products, boxes, wound);
        for (const auto& leaf : plan.leaves) {
            ASSERT_EQ(leaf.slot / 32 >= plan.first_counter(), wound[leaf.leaf] != 0);
        }
        for (int probe = 0; probe < 400; ++probe) {
            const auto x = static_cast<std::uint32_t>(pick(400)), y = static_cast<std::uint32_t>(pick(400));
            const auto holds = [&](const goldfeather::PixelBox& b) {
                return b.x0 <= x && x < b.x1 && b.y0 <= y && y < b.y1;
            };
            // Any leaf whose projection reaches the pixel can hold the point.
            std::vector<char> inside(boxes.size());
            for (csg::LeafId leaf = 0; leaf < boxes.size(); ++leaf) {
                const auto r = view.screen_box(boxes[leaf].lo, boxes[leaf].hi);
                const bool reaches = r.x0 <= static_cast<int>(x) && static_cast<int>(x) < r.x1 &&
                                     r.y0 <= static_cast<int>(y) && static_cast<int>(y) < r.y1;
                inside[leaf] = reaches && pick(2) == 0;
            }
            std::vector<std::uint32_t> bits(plan.words() + 1);
            for (const auto& leaf : plan.leaves) {
                if (inside[leaf.leaf]) {
                    bits[leaf.slot / 32] ^= wound[leaf.leaf] ? ~0U : 1U << (leaf.slot % 32);
                }
            }
            const bool expected = std::any_of(products.begin(), products.end(), [&](const Product& p) {
                return std::all_of(p.literals.begin(), p.literals.end(),
                                   [&](const Literal& l) { return (inside[l.leaf] != 0) != l.complement; });
            });
            bool actual = false;
            for (const auto& tile : plan.tiles) {
                if (!holds(tile.box)) {
                    continue;
                }
                for (std::uint32_t i = 0; i < tile.product_count; ++i) {
                    const auto& p = plan.products[plan.tile_products[tile.first_product + i]];
                    actual |= holds(p.box) && std::all_of(plan.entries.begin() + p.first_entry,
                                                          plan.entries.begin() + p.first_entry + p.entry_count,
                                                          [&](const goldfeather::Entry& e) {
                                                              return (bits[e.word] & e.set) == e.set &&
                                                                     (bits[e.word] & e.clear) == 0;
                                                          });
                }
            }
            ASSERT_EQ(actual, expected) << "round " << round << ", pixel " << x << ", " << y;
        }
    }
}

}  // namespace
