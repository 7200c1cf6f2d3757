// When bodies begin to touch, against times that are known.
#include "ui/pipeline/motion/contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "tests/csg/scad/evaluate_text.h"
#include "ui/pipeline/motion/key_times.h"

namespace ui {
namespace {

Motion motion_of(const std::string& text, std::optional<double> error = {}) {
    MotionRequest request;
    request.derivatives = false;
    request.error = error;
    return find_motion(
        [&](double time) {
            csg::scad::Request at;
            at.time = time;
            return test::run(text, {}, at).evaluation.tree;
        },
        request);
}

std::vector<Contact> contacts(const Motion& motion, const std::string& name, const std::string& with = "*",
                              double from = 0, double to = 1) {
    for (const MovingBody& body : motion.bodies) {
        if (body.name == name) {
            return contacts_of(
                motion, body, [&](const std::string& other) { return with == "*" || other == with; }, from, to);
        }
    }
    ADD_FAILURE() << "no " << name;
    return {};
}

TEST(Contact, SlidesIntoAWall) {
    // The face x = 10 t + 2 meets the wall x = 7.
    const Motion motion = motion_of("translate([10 * $t, 0, 0]) cube(2); translate([7, -5, -5]) cube([1, 20, 20]);");
    const auto found = contacts(motion, "cube");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].time, 0.5, motion.error / 10 + 1e-8);
    EXPECT_NEAR(found[0].point.x, 7, 1e-6);
    EXPECT_EQ(found[0].with, "");
    EXPECT_TRUE(contacts(motion, "cube", "*", 0, 0.4).empty());
    EXPECT_TRUE(contacts(motion, "cube", "other").empty());
}

TEST(Contact, FollowsWhatSpeedsUp) {
    // Falls from 20 above the floor: 20 - 45 t^2, at 90 t.
    const Motion motion = motion_of(
        "module ball() cube(2, center = true); translate([0, 0, 21 - 45 * $t * $t]) ball();"
        "translate([-9, -9, -1]) cube([18, 18, 1]);");
    const auto found = contacts(motion, "ball");
    const double exact = std::sqrt(20 / 45.0);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_GT(motion.error, 0);
    EXPECT_NEAR(found[0].time, exact, motion.error / (90 * exact) + 1e-8);
    EXPECT_NEAR(found[0].point.z, 0, 2 * motion.error);
}

TEST(Contact, EachTimeThatItBounces) {
    // Touches at t = 0.25 and 0.75, and parts again at once.
    const Motion motion = motion_of(
        "module ball() cube(2, center = true); translate([0, 0, 1 + 10 * abs(cos(360 * $t))]) ball();"
        "translate([-9, -9, -1]) cube([18, 18, 1]);",
        1e-3);
    const auto found = contacts(motion, "ball");
    ASSERT_EQ(found.size(), 2u);
    const double speed = 20 * std::numbers::pi;
    EXPECT_NEAR(found[0].time, 0.25, 2 * motion.error / speed + 1e-7);
    EXPECT_NEAR(found[1].time, 0.75, 2 * motion.error / speed + 1e-7);
}

TEST(Contact, TurnsIntoWhatMovesItself) {
    // An arm of length 10 turns by a right angle; a block comes down the y axis to meet its end.
    const Motion motion = motion_of(
        "module arm() cube([10, 1, 1]); module block() translate([-3, 0, 0]) cube([6, 2, 1]);"
        "rotate(90 * $t) arm(); translate([0, 20 - 10 * $t, 0]) block();");
    const auto arm = contacts(motion, "arm", "block"), block = contacts(motion, "block", "arm");
    ASSERT_EQ(arm.size(), 1u);
    ASSERT_EQ(block.size(), 1u);
    // The corner [10, 1] is highest: 10 sin a + cos a = 20 - 10 t.
    double low = 0.5, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double t = 0.5 * (low + high), a = 0.5 * std::numbers::pi * t;
        (10 * std::sin(a) + std::cos(a) < 20 - 10 * t ? low : high) = t;
    }
    EXPECT_NEAR(arm[0].time, low, 2 * motion.error / 10 + 1e-7);
    EXPECT_NEAR(block[0].time, arm[0].time, 1e-6);
    EXPECT_EQ(arm[0].with, "block");
}

TEST(Contact, WhatTouchesFromTheFirstBeginsNothing) {
    const Motion motion = motion_of(
        "translate([10 * $t, 0, 0]) cube(2); translate([-5, -5, -1]) cube([30, 20, 1]);"
        "module hole() difference() { translate([20, -5, 0]) cube([4, 20, 4]); translate([19, 0, 0]) cube([6, 2, 4]); }"
        "hole();");
    EXPECT_TRUE(contacts(motion, "cube").empty()) << "it slides on the floor, towards a hole as wide as it is";
}

TEST(Contact, WhatItRestsOnHidesNoOther) {
    // Slides on one block towards another.
    const Motion motion = motion_of(
        "translate([10 * $t, 0, 0]) cube(2); translate([0, 0, -1]) cube([12, 2, 1]);"
        "translate([9, -4, 1]) cube([2, 10, 3]);");
    const auto found = contacts(motion, "cube");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].time, 0.7, 1e-8);
}

TEST(Contact, AShortPartingBetweenSamples) {
    // A pin slides over a floor with a notch that is a little wider than the pin: 18 units in all of the time, of which
    // it is free for 0.05. The motion is one straight line, of which few samples are taken.
    const Motion motion = motion_of(
        "module pin() cube([0.2, 1, 1]); translate([18 * $t, 0, 0]) pin();"
        "difference() { translate([-5, -5, -1]) cube([40, 20, 1]); translate([9, -6, -0.5]) cube([0.25, 30, 2]); }");
    ASSERT_LT(motion.times.size(), 60u);
    const auto found = contacts(motion, "pin");
    ASSERT_EQ(found.size(), 1u) << "what it slides on it touches from the first";
    // The leading edge, 0.2 before the pin's own place, comes to the far side of the notch.
    EXPECT_NEAR(found[0].time, (9.25 - 0.2) / 18, motion.error / 18 + 1e-8);
    EXPECT_NEAR(found[0].point.x, 9.25, 1e-6);
}

TEST(Contact, EachToothThatAWheelHitsWithinASample) {
    // An arm of length 10 that turns evenly hits five teeth of one comb, a degree and a half apart.
    const Motion motion = motion_of(
        "module arm() translate([0, -0.05, 0]) cube([10, 0.1, 1]); rotate(360 * $t) arm();"
        "module comb() { translate([0, 0, -3]) cylinder(r = 12, h = 1);"
        "for (i = [0:4]) rotate(40 + 1.5 * i) translate([9.8, -0.02, -2.5]) cube([1, 0.04, 4]); }"
        "union() comb();");
    const auto found = contacts(motion, "arm");
    ASSERT_EQ(found.size(), 5u);
    for (std::size_t i = 0; i < found.size(); ++i) {
        // The arm's leading side, at y = 0.05 of its own, meets the tooth's face at y = -0.02 of the tooth's: first
        // where the tooth begins, 9.8 out, or at the end of the arm.
        const double tooth = (40 + 1.5 * static_cast<double>(i)) * std::numbers::pi / 180;
        const double own = std::atan2(0.05, 10), its = std::asin(-0.02 / std::hypot(10, 0.05));
        const double at_end = tooth + its - own;
        const double begins = tooth + std::atan2(-0.02, 9.8) - std::asin(0.05 / std::hypot(9.8, 0.02));
        EXPECT_NEAR(found[i].time, std::min(at_end, begins) / (2 * std::numbers::pi), 2 * motion.error / 60 + 1e-7)
            << i;
    }
}

TEST(Contact, AGraze) {
    // The edges of a block that turns come as near to a wall as the wall is: they touch it for no time at all.
    const std::string block = "rotate(360 * $t) cube([4, 4, 2], center = true);";
    const auto wall = [](double x) { return "translate([" + std::to_string(x) + ", -9, -9]) cube([1, 18, 18]);"; };
    const double reach = 2 * std::numbers::sqrt2;
    const Motion motion = motion_of(block + "translate([2 * sqrt(2), -9, -9]) cube([1, 18, 18]);");
    const auto found = contacts(motion, "cube");
    ASSERT_EQ(found.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        // The distance grows by the square of the time: what is told to within the rounding of lengths is told to
        // within its root in times.
        EXPECT_NEAR(found[i].time, 0.125 + 0.25 * static_cast<double>(i), 1e-5);
        EXPECT_NEAR(found[i].point.x, reach, 1e-6);
    }
    EXPECT_TRUE(contacts(motion_of(block + wall(reach + 1e-4)), "cube").empty());
    EXPECT_EQ(contacts(motion_of(block + wall(reach - 1e-4)), "cube").size(), 4u);
}

TEST(Contact, InsideIsNoParting) {
    // A small ball flies into a large block, and out again.
    const Motion motion = motion_of(
        "module ball() cube(1, center = true); translate([30 * $t - 15, 0, 0]) ball(); cube(12, center = true);");
    const auto found = contacts(motion, "ball");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].time, (15 - 6.5) / 30, 1e-8);
}

TEST(Contact, ABodyOfTwoPiecesTouchesOnce) {
    const Motion motion = motion_of(
        "module car() cube([8, 4, 1]); module load() translate([2, 1, 1.001]) cube(2);"
        "translate([40 * $t, 0, 0]) { car(); load(); }"
        "module stop() translate([30, 1, 0]) cube([1, 1, 4]); stop();");
    // All of it moves alike: it is one body, with a gap that stays.
    ASSERT_EQ(motion.bodies.size(), 1u);
    EXPECT_EQ(contacts(motion, motion.bodies[0].name).size(), 1u);
}

TEST(KeyTimes, AreWhereMotionsChange) {
    // Slides for 0.3, rests until 0.6, turns until the end.
    const Motion motion = motion_of(
        "module door() cube([4, 1, 8]);"
        "translate([40 * min($t, 0.3), 0, 0]) rotate(200 * max(0, $t - 0.6)) door(); translate([0, 20, 0]) cube(1);");
    const std::vector<double> keys = key_times(motion, 4);
    ASSERT_EQ(keys.size(), 4u);
    EXPECT_EQ(keys[0], 0);
    EXPECT_NEAR(keys[1], 0.3, 0.02);
    EXPECT_NEAR(keys[2], 0.6, 0.02);
    EXPECT_EQ(keys[3], 1);
    EXPECT_EQ(what_moves(motion, 0, keys[1]), "door slides");
    EXPECT_EQ(what_moves(motion, keys[2] + 0.02, 1), "door turns");
    EXPECT_EQ(what_moves(motion, 0.35, 0.55), "");
    EXPECT_EQ(key_times(motion, 1), (std::vector<double>{0}));
    // What ends as it began is shown once; what does not change is shown evenly.
    const std::vector<double> turning = key_times(motion_of("rotate(360 * $t) translate([5, 0, 0]) cube(1);"), 4);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(turning[i], 0.25 * static_cast<double>(i), 0.02);
    }
    EXPECT_EQ(what_moves(motion_of("for (i = [0:2]) translate([9 * i, (i + 1) * $t, 0]) cube(1);"), 0, 1),
              "cube ×3 slides");
    EXPECT_EQ(key_times(motion_of("translate([$t, 0, 0]) cube(1);"), 3), (std::vector<double>{0, 0.5, 1}));
    EXPECT_EQ(key_times(motion_of("cube(1);"), 2), (std::vector<double>{0, 0.5}));
}

}  // namespace
}  // namespace ui
