// The parts of the window fill it and do not overlap.
#include "ui/viewer/layout.h"

#include <gtest/gtest.h>

namespace ui {
namespace {

float area(const Rectangle& r) {
    return r.size.x * r.size.y;
}

TEST(Layout, PartsFillTheWindow) {
    for (const glm::vec2 window : {glm::vec2(1280, 800), glm::vec2(320, 240), glm::vec2(3840, 2160), glm::vec2(1, 1)}) {
        for (const float scale : {1.0F, 1.5F, 3.0F}) {
            for (int bits = 0; bits < 12; ++bits) {
                Shown shown;
                shown.panel = (bits & 1) != 0;
                shown.console = (bits & 2) != 0;
                shown.customizer = bits >= 4 && bits < 8;
                shown.text = bits >= 8;
                const float menu = std::min(24 * scale, window.y);
                const Layout layout = make_layout(window, std::floor(menu), scale, shown, 150 * scale);
                const float covered = area(layout.picture) + area(layout.panel) + area(layout.console) +
                                      area(layout.status) + area(layout.left);
                EXPECT_FLOAT_EQ(covered, window.x * (window.y - std::floor(menu)));
                EXPECT_GE(layout.picture.size.x, std::min(240 * scale, std::floor(window.x / 3)));
                for (const Rectangle& r : {layout.picture, layout.panel, layout.console, layout.status, layout.left}) {
                    EXPECT_GE(r.corner.x, 0);
                    EXPECT_GE(r.corner.y, 0);
                    EXPECT_LE(r.corner.x + r.size.x, window.x);
                    EXPECT_LE(r.corner.y + r.size.y, window.y);
                }
            }
        }
    }
}

TEST(Layout, TheConsoleLeavesRoomForThePicture) {
    const Layout layout = make_layout({1280, 800}, 24, 1, {}, 10'000);
    EXPECT_GT(layout.picture.size.y, 200);
    EXPECT_GE(make_layout({1280, 800}, 24, 1, {}, -50).console.size.y, 60);
}

TEST(Layout, SmallWindowsAreThePictures) {
    const Layout small = make_layout({400, 300}, 24, 1, {}, 150);
    EXPECT_TRUE(small.panel.empty());
    EXPECT_TRUE(small.console.empty());
    EXPECT_EQ(small.picture.size.x, 400);
    EXPECT_EQ(make_layout({800, 600}, 24, 2, {}, 300).picture.size.x, 800) << "as large things are on the display";
    EXPECT_FALSE(make_layout({800, 600}, 24, 1, {}, 150).panel.empty());
}

TEST(Layout, WhatIsClosedLeavesItsPlaceToThePicture) {
    Shown shown;
    shown.panel = shown.console = false;
    const Layout layout = make_layout({1280, 800}, 24, 1, shown, 150);
    EXPECT_TRUE(layout.panel.empty());
    EXPECT_TRUE(layout.console.empty());
    EXPECT_EQ(layout.picture.size.x, 1280);
}

TEST(Layout, ARectangleContainsItsInside) {
    const Rectangle r{{10, 20}, {5, 5}};
    EXPECT_TRUE(r.contains({10, 20}));
    EXPECT_TRUE(r.contains({14.9, 24.9}));
    EXPECT_FALSE(r.contains({15, 20}));
    EXPECT_FALSE(r.contains({9.9, 20}));
}

}  // namespace
}  // namespace ui
