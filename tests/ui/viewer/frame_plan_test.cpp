// Coarse while things move, whole when they rest, then sample by sample; nothing when nothing changes.
#include "ui/viewer/frame_plan.h"

#include <gtest/gtest.h>

#include <vector>

namespace ui {
namespace {

/// A renderer that needs a fixed time and a time per pixel.
class Plan : public testing::Test {
  protected:
    Plan() {
        plan_.set_samples(4);
        plan_.replaced(now_);
    }

    double cost(int divisor) const { return fixed_ + whole_ / (divisor * divisor); }

    /// Draws the next step, if there is one.
    std::optional<PictureStep> draw() {
        const auto step = plan_.next(now_);
        if (step) {
            now_ += cost(step->divisor);
            plan_.drawn(*step, cost(step->divisor));
        }
        return step;
    }

    std::vector<PictureStep> draw_until_rest() {
        std::vector<PictureStep> steps;
        for (int i = 0; i < 1000 && !plan_.finished(); ++i) {
            if (const auto step = draw()) {
                steps.push_back(*step);
            } else {
                now_ += 0.01;
            }
        }
        return steps;
    }

    FramePlan plan_;
    double now_ = 10;
    double fixed_ = 0.002, whole_ = 0.4;
};

TEST_F(Plan, TheFirstLookIsRefinedToAllSamplesAndThenRests) {
    const auto steps = draw_until_rest();
    ASSERT_GE(steps.size(), 4U);
    EXPECT_EQ(steps.front().sample, 0);
    const std::vector<PictureStep> end(steps.end() - 4, steps.end());
    EXPECT_EQ(end, (std::vector<PictureStep>{{1, 0}, {1, 1}, {1, 2}, {1, 3}}));
    EXPECT_TRUE(plan_.finished());
    EXPECT_EQ(plan_.next(now_ + 100), std::nullopt);
    EXPECT_EQ(plan_.wait(now_ + 100), std::nullopt);
}

TEST_F(Plan, TheFirstLookIsCheapWhateverTheModel) {
    whole_ = 36;
    EXPECT_EQ(draw(), (PictureStep{6, 0}));
}

TEST_F(Plan, AVerySlowPictureFollowsSoonWhereItCanBeStopped) {
    whole_ = 20;
    plan_.set_stoppable(true);
    ASSERT_TRUE(draw().has_value());
    const double looked_at = now_;
    std::optional<PictureStep> step;
    while ((step = plan_.next(now_)) != PictureStep{1, 0}) {
        if (!draw()) {
            now_ += 0.01;
        }
        ASSERT_LT(now_, looked_at + 1.5);
    }
}

TEST_F(Plan, StepsHinderWhereACoarserOneWouldBeDrawnNow) {
    draw_until_rest();
    EXPECT_FALSE(plan_.hinders({1, 3})) << "nothing has changed";
    plan_.moved(now_);
    EXPECT_TRUE(plan_.hinders({1, 0}));
    EXPECT_TRUE(plan_.hinders({6, 1})) << "a further sample";
    // What is drawn while things move is as coarse as it can be: were it stopped, nothing would be seen.
    const auto step = plan_.next(now_);
    ASSERT_TRUE(step.has_value());
    EXPECT_GT(step->divisor, 1);
    EXPECT_FALSE(plan_.hinders(*step));
}

TEST_F(Plan, AVerySlowPictureIsFinishedOnlyWhenNothingHasHappenedForAWhile) {
    whole_ = 20;
    const auto step = draw();
    ASSERT_TRUE(step.has_value());
    const double looked_at = now_;
    while (const auto finer = draw()) {
        EXPECT_LE(cost(finer->divisor), 1.5) << "divisor " << finer->divisor;
        ASSERT_LT(now_, looked_at + 10);
        if (now_ > looked_at + 1) {
            break;
        }
    }
    plan_.moved(now_);
    EXPECT_GT(draw()->divisor, 1);
    const auto steps = draw_until_rest();
    EXPECT_EQ(steps.back(), (PictureStep{1, 3}));
}

TEST_F(Plan, MotionKeepsToItsBudgetOnASlowRenderer) {
    (void)draw_until_rest();
    for (int i = 0; i < 30; ++i) {
        plan_.moved(now_);
        const auto step = draw();
        ASSERT_TRUE(step.has_value());
        EXPECT_EQ(step->sample, 0);
        if (i > 2) {  // The cost of a coarse picture has to be found out.
            EXPECT_LE(cost(step->divisor), 0.06) << "divisor " << step->divisor;
        }
        EXPECT_EQ(plan_.next(now_), std::nullopt) << "no refinement while it moves";
        EXPECT_GT(plan_.wait(now_).value(), 0);
    }
    const auto steps = draw_until_rest();
    EXPECT_EQ(steps, (std::vector<PictureStep>{{1, 0}, {1, 1}, {1, 2}, {1, 3}}));
}

TEST_F(Plan, MotionIsWholeOnAFastRenderer) {
    fixed_ = 0.001;
    whole_ = 0.01;
    (void)draw_until_rest();
    for (int i = 0; i < 10; ++i) {
        plan_.moved(now_);
        EXPECT_EQ(draw(), (PictureStep{1, 0}));
        now_ += 0.016;
    }
    EXPECT_EQ(draw_until_rest(), (std::vector<PictureStep>{{1, 1}, {1, 2}, {1, 3}})) << "the first sample is kept";
}

TEST_F(Plan, AChangeDuringRefinementBeginsAnew) {
    while (draw() != PictureStep{1, 0}) {
        ASSERT_LT(now_ += 0.01, 20);
    }
    EXPECT_EQ(draw(), (PictureStep{1, 1}));
    plan_.moved(now_);
    EXPECT_EQ(draw()->sample, 0);
    EXPECT_FALSE(plan_.finished());
}

TEST_F(Plan, SomethingElseIsRefinedAtOnce) {
    (void)draw_until_rest();
    plan_.replaced(now_);
    EXPECT_EQ(draw()->sample, 0);
    EXPECT_TRUE(plan_.next(now_).has_value());
    EXPECT_EQ(plan_.wait(now_), 0);
}

TEST_F(Plan, OneSampleIsOneStep) {
    fixed_ = 0.001;
    whole_ = 0.001;
    (void)draw_until_rest();
    plan_.set_samples(1);
    plan_.moved(now_);
    EXPECT_EQ(draw(), (PictureStep{1, 0}));
    EXPECT_TRUE(plan_.finished());
}

TEST_F(Plan, ARendererThatIsSlowWhateverTheSizeStillShowsMotion) {
    fixed_ = 1;
    (void)draw_until_rest();
    plan_.moved(now_);
    EXPECT_GT(draw()->divisor, 1);
}

TEST_F(Plan, AMomentOfABusyMachineIsForgotten) {
    fixed_ = 0.001;
    whole_ = 0.04;  // Half of it fits into the time of a moving picture ten times.
    (void)draw_until_rest();
    const auto moving = [&] {
        plan_.moved(now_);
        return draw()->divisor;
    };
    const int usual = moving();
    ASSERT_LE(usual, 2);
    fixed_ = 0.5;  // Everything takes long for a while.
    for (int i = 0; i < 10; ++i) {
        (void)moving();
    }
    EXPECT_EQ(moving(), 6);
    fixed_ = 0.001;
    for (int i = 0; i < 200; ++i) {
        (void)moving();
    }
    EXPECT_EQ(moving(), usual);
}

TEST_F(Plan, WhatTakesLongIsNotTriedAgainAndAgain) {
    fixed_ = 0.02;
    whole_ = 1.0;
    (void)draw_until_rest();
    int slow = 0;
    for (int i = 0; i < 400; ++i) {
        plan_.moved(now_);
        slow += cost(draw()->divisor) > 0.06 ? 1 : 0;
    }
    EXPECT_LE(slow, 400 / 20);
}

}  // namespace
}  // namespace ui
