// What moves while $t runs: against closed forms.
#include "ui/pipeline/motion/motion.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/csg/scad/evaluate_text.h"
#include "ui/pipeline/motion/character.h"
#include "ui/pipeline/motion/rigid_motion.h"

namespace ui {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Motion motion_of(const std::string& program, MotionRequest request = {}) {
    csg::scad::ProgramCache programs;
    const auto tree_at = [&](double t) {
        csg::scad::Request at;
        at.time = t;
        const test::Run run = test::run_kept(programs, program, {}, at);
        EXPECT_TRUE(run.evaluation.ok) << run.console;
        return run.evaluation.tree;
    };
    return find_motion(tree_at, request);
}

void expect_near(const glm::dvec3& is, const glm::dvec3& right, double tolerance) {
    EXPECT_LE(glm::distance(is, right), tolerance)
        << is.x << " " << is.y << " " << is.z << " instead of " << right.x << " " << right.y << " " << right.z;
}

TEST(Screw, IsFoundAgain) {
    std::mt19937 random(1);
    const auto number = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 axis = glm::normalize(glm::dvec3(number(), number(), number()));
        const double angles[] = {std::abs(number()) * kTurn / 2, 1e-5, 1e-9, kTurn / 2 - 1e-8, kTurn / 2};
        Screw screw{axis, glm::dvec3(number(), number(), number()), angles[i % 5], number()};
        const glm::dmat4 motion = matrix_of(screw, 1);
        const auto found = screw_of(motion);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->angle, screw.angle, 1e-8);
        const glm::dmat4 again = matrix_of(*found, 1), half = matrix_of(*found, 0.5);
        for (int k = 0; k < 4; ++k) {
            EXPECT_LE(glm::length(again[k] - motion[k]), 5e-8) << screw.angle;
            EXPECT_LE(glm::length((half * half)[k] - motion[k]), 5e-8) << screw.angle;
        }
    }
    EXPECT_FALSE(screw_of(glm::dmat4(2.0)));
    glm::dmat4 mirrored(1.0);
    mirrored[0][0] = -1;
    EXPECT_FALSE(screw_of(mirrored));
}

/// A slider-crank: r = 8, l = 30.
constexpr const char* kCrank =
    "module crank() { difference() { cylinder(h = 2, r = 10); translate([0, 0, -1]) cylinder(h = 4, r = 2); } "
    "translate([8, 0, 2]) cylinder(h = 3, r = 1); }\n"
    "a = 360 * $t; x = 8 * cos(a) + sqrt(900 - pow(8 * sin(a), 2));\n"
    "rotate(a) crank();\n"
    "translate([x, 0, 5]) cube([10, 6, 4], center = true);\n"
    "translate([0, 0, -20]) cube([80, 80, 2], center = true);\n";

TEST(Motion, FollowsACrank) {
    const Motion motion = motion_of(kCrank);
    EXPECT_TRUE(motion.complete);
    EXPECT_EQ(motion.leaves, 5u);
    EXPECT_EQ(motion.still, 1u);
    ASSERT_EQ(motion.bodies.size(), 2u);
    EXPECT_EQ(motion.bodies[0].name, "crank");
    EXPECT_EQ(motion.bodies[1].name, "cube");
    EXPECT_EQ(motion.bodies[1].where.line, 4u);

    const Character crank = character_of(motion, motion.bodies[0]);
    EXPECT_EQ(crank.kind, Character::Kind::Turns);
    expect_near(crank.axis, {0, 0, 1}, 1e-9);
    expect_near(crank.point, {0, 0, 0}, 1e-9);
    EXPECT_NEAR(crank.turned_net, kTurn, 1e-9);

    const Character slider = character_of(motion, motion.bodies[1]);
    EXPECT_EQ(slider.kind, Character::Kind::Slides);
    EXPECT_NEAR(slider.way, 32, 0.1);  // There and back; how far exactly it comes lies between two samples.
    EXPECT_NEAR(slider.way_net, 0, 1e-9);

    const auto place = [](double t) {
        const double s = 8 * std::sin(kTurn * t);
        return 8 * std::cos(kTurn * t) + std::sqrt(900 - s * s);
    };
    for (std::size_t i = 0; i < motion.times.size(); ++i) {
        const double t = motion.times[i];
        const Pose& pose = *motion.bodies[1].poses[i];
        expect_near(pose.center, {place(t), 0, 5}, 1e-9);
        ASSERT_TRUE(pose.velocity && pose.acceleration);
        const double h = 1e-4;
        const double velocity = (place(t + h) - place(t - h)) / (2 * h);
        const double acceleration = (place(t + h) - 2 * place(t) + place(t - h)) / (h * h);
        expect_near(*pose.velocity, {velocity, 0, 0}, 1e-4);
        expect_near(*pose.acceleration, {acceleration, 0, 0}, i == 0 || i + 1 == motion.times.size() ? 0.05 : 1e-3);
        expect_near(*motion.bodies[0].poses[i]->turning, {0, 0, kTurn}, 1e-6);
    }
}

/// Between samples everything is where the screw has it, to within the error that is told.
TEST(Motion, IsKnownBetweenItsSamples) {
    MotionRequest request;
    request.derivatives = false;
    for (const double error : {0.1, 0.01, 0.001}) {
        request.error = error;
        const Motion motion = motion_of(kCrank, request);
        EXPECT_LE(motion.error, error);
        for (double t = 0.0007; t < 1; t += 0.00371) {
            const auto next = std::upper_bound(motion.times.begin(), motion.times.end(), t);
            const auto i = static_cast<std::size_t>(next - motion.times.begin()) - 1;
            const double share = (t - motion.times[i]) / (motion.times[i + 1] - motion.times[i]);
            const MovingBody& slider = motion.bodies[1];
            const glm::dmat4 at = between(slider.poses[i]->motion, slider.poses[i + 1]->motion, share);
            const double s = 8 * std::sin(kTurn * t), x = 8 * std::cos(kTurn * t) + std::sqrt(900 - s * s);
            EXPECT_NEAR(at[3].x + slider.poses[0]->center.x, x, motion.error) << t;
        }
    }
}

TEST(Motion, FindsWhenSomethingJumpsComesAndGoes) {
    const Motion motion = motion_of(
        "translate([$t < 0.3 ? 0 : 12, 0, 0]) cube(4);\n"
        "if ($t > 0.25 && $t < 0.7) translate([0, 40, 0]) sphere(3);\n"
        "for (i = [0 : floor(3.5 * $t)]) translate([10 * i, 80, 0]) cylinder();\n"
        "translate([0, 99, 0]) cube([1, 1, 2 + $t]);\n");
    ASSERT_EQ(motion.bodies.size(), 6u);
    const auto expect = [&](std::size_t body, std::size_t event, MotionEvent::Kind kind, double when) {
        ASSERT_LT(event, motion.bodies[body].events.size()) << body;
        const MotionEvent& e = motion.bodies[body].events[event];
        EXPECT_EQ(e.kind, kind) << body;
        EXPECT_LE(e.after, when);
        EXPECT_GE(e.before, when);
        EXPECT_LT(e.before - e.after, 1e-5);
    };
    expect(0, 0, MotionEvent::Kind::Jumps, 0.3);
    EXPECT_NEAR(motion.bodies[0].events[0].distance, 12, 1e-9);
    EXPECT_FALSE(motion.bodies[0].poses.back()->velocity && glm::length(*motion.bodies[0].poses.back()->velocity) > 0);
    EXPECT_TRUE(motion.bodies[1].changes_shape);
    EXPECT_TRUE(motion.bodies[1].events.empty());
    EXPECT_EQ(character_of(motion, motion.bodies[1]).kind, Character::Kind::Stays);
    EXPECT_EQ(motion.bodies[2].name, "sphere");
    expect(2, 0, MotionEvent::Kind::Appears, 0.25);
    expect(2, 1, MotionEvent::Kind::Vanishes, 0.7);
    for (std::size_t i = 3; i < 6; ++i) {
        expect(i, 0, MotionEvent::Kind::Appears, static_cast<double>(i - 2) / 3.5);
        EXPECT_EQ(motion.bodies[i].events.size(), 1u);
    }
    EXPECT_EQ(motion.bodies[5].name, "cylinder 3");
}

TEST(Motion, IsNotTakenForRestWhereWholeTurnsLieBetweenSamples) {
    for (const int turns : {16, 17, 32, 64}) {
        const Motion motion = motion_of(fmt::format("rotate({} * $t) translate([5, 0, 0]) cube(1);", 360 * turns));
        ASSERT_EQ(motion.bodies.size(), 1u) << turns;
        const Character c = character_of(motion, motion.bodies[0]);
        EXPECT_EQ(c.kind, Character::Kind::Turns);
        EXPECT_NEAR(c.turned_net, turns * kTurn, 1e-6);
    }
}

TEST(Motion, HasACharacter) {
    const auto only = [](const std::string& program) {
        const Motion motion = motion_of(program);
        EXPECT_EQ(motion.bodies.size(), 1u) << program;
        return character_of(motion, motion.bodies.front());
    };
    const Character screw = only("translate([3, 4, 10 * $t]) rotate(720 * $t) cube(2);");
    EXPECT_EQ(screw.kind, Character::Kind::Screws);
    expect_near(screw.point, {3, 4, 0}, 1e-9);
    EXPECT_NEAR(screw.way_net, 10, 1e-9);
    EXPECT_NEAR(screw.turned_net, 2 * kTurn, 1e-9);
    const Character door = only("translate([7, 0, 0]) rotate([0, 0, 90 * sin(180 * $t)]) cube([5, 1, 9]);");
    EXPECT_EQ(door.kind, Character::Kind::Turns);
    expect_near(door.point, {7, 0, 0}, 1e-9);
    EXPECT_NEAR(door.turned_net, 0, 1e-9);
    EXPECT_NEAR(door.turned, kTurn / 2, 0.01);
    const Character planet = only("rotate(360 * $t) translate([10, 0, 0]) rotate(-900 * $t) cube(2, center = true);");
    EXPECT_EQ(planet.kind, Character::Kind::Moves);
    EXPECT_NEAR(planet.way, 10 * kTurn, 0.01);
    EXPECT_EQ(only("translate(20 * [cos(360 * $t), sin(360 * $t), 0]) cube(2);").kind, Character::Kind::Travels);
    EXPECT_EQ(only("scale([1, 1 + $t, 1]) cube(2);").kind, Character::Kind::Deforms);
    const Character slide = only("translate([0, -6 * $t, 8 * $t]) cube(2);");
    EXPECT_EQ(slide.kind, Character::Kind::Slides);
    expect_near(slide.axis, {0, -0.6, 0.8}, 1e-9);
    EXPECT_NEAR(slide.way_net, 10, 1e-9);
}

/// What moves alike is one body as far up as nothing else is there; what is subtracted moves as well.
TEST(Motion, IsOfWholeSubtrees) {
    const Motion motion = motion_of(
        "module wheel() { cylinder(r = 5); translate([3, 0, 0]) sphere(1); }\n"
        "for (x = [0, 20]) translate([x, 0, 0]) rotate(x == 0 ? 90 * $t : -90 * $t) wheel();\n"
        "translate([5 * $t, 30, 0]) { wheel(); translate([20, 0, 0]) wheel(); }\n"
        "difference() { translate([0, 60, 0]) cube(10); translate([3 * $t, 63, -1]) cube([2, 2, 20]); }\n");
    ASSERT_EQ(motion.bodies.size(), 4u);
    EXPECT_EQ(motion.bodies[0].name, "wheel");
    EXPECT_EQ(motion.bodies[1].name, "wheel 2");
    EXPECT_EQ(motion.bodies[2].name, "wheel 3");
    EXPECT_EQ(motion.bodies[2].where.line, 3u);
    EXPECT_GT(motion.bodies[2].box.hi.x, 24);
    EXPECT_EQ(motion.bodies[3].name, "cube");
    EXPECT_TRUE(motion_of("cube(3);").bodies.empty());
}

TEST(Motion, EndsWhereThereIsNoModel) {
    const auto never = [](double t) { return t < 0.5 ? test::run("cube(1);").evaluation.tree : nullptr; };
    EXPECT_THROW((void)find_motion(never, {}), std::runtime_error);
    MotionRequest few;
    few.most_samples = 20;
    few.derivatives = false;
    EXPECT_FALSE(motion_of(kCrank, few).complete);
}

}  // namespace
}  // namespace ui
