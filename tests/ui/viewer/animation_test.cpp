// $t in real time.
#include "ui/viewer/animation.h"

#include <gtest/gtest.h>

namespace ui {
namespace {

TEST(Animation, RunsInRealTimeAndLeavesOutWhatThereWasNoTimeFor) {
    Animation animation;
    animation.set_steps(10);
    animation.set_rate(5);
    EXPECT_FALSE(animation.advance(100)) << "it does not play";
    animation.play(true, 100);
    EXPECT_FALSE(animation.advance(100.1));
    EXPECT_TRUE(animation.advance(100.25));
    EXPECT_EQ(animation.step(), 1);
    EXPECT_FALSE(animation.advance(100.3));
    EXPECT_TRUE(animation.advance(101.45)) << "the machine was busy";
    EXPECT_EQ(animation.step(), 7);
    EXPECT_DOUBLE_EQ(animation.time(), 0.7);
    EXPECT_TRUE(animation.advance(102.25)) << "round again";
    EXPECT_EQ(animation.step(), 1);
    animation.play(false, 102.3);
    EXPECT_FALSE(animation.advance(110));
    animation.play(true, 200);
    EXPECT_TRUE(animation.advance(200.21)) << "from where it was";
    EXPECT_EQ(animation.step(), 2);
}

TEST(Animation, StepsAreOfTheCycle) {
    Animation animation;
    animation.set_steps(10);
    animation.go_to(-1);
    EXPECT_EQ(animation.step(), 9);
    animation.go_to(10);
    EXPECT_EQ(animation.step(), 0);
    animation.go_to(5);
    animation.set_steps(100);
    EXPECT_EQ(animation.step(), 50) << "the same time";
    animation.set_steps(0);
    EXPECT_EQ(animation.steps(), 1);
    EXPECT_EQ(animation.time(), 0);
}

}  // namespace
}  // namespace ui
