// The newest job counts: an older one is asked to stop and its result dropped.
#include "ui/viewer/latest_job.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>

namespace ui {
namespace {

using namespace std::chrono_literals;

/// The next result, or -1 where none comes.
int wait_for(LatestJob<int>& jobs) {
    for (int i = 0; i < 1000; ++i) {
        if (const auto result = jobs.take()) {
            return *result;
        }
        std::this_thread::sleep_for(5ms);
    }
    return -1;
}

/// Runs until it is asked to stop.
int run_until_stopped(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::this_thread::sleep_for(1ms);
    }
    return 1;
}

TEST(LatestJob, GivesAResultOnceAndWakes) {
    std::promise<void> woken;
    LatestJob<int> jobs([&] { woken.set_value(); });
    EXPECT_FALSE(jobs.busy());
    jobs.start([](std::stop_token) { return 7; });
    ASSERT_EQ(woken.get_future().wait_for(5s), std::future_status::ready);
    EXPECT_EQ(jobs.take(), 7);
    EXPECT_EQ(jobs.take(), std::nullopt);
    EXPECT_FALSE(jobs.busy());
}

TEST(LatestJob, ANewerJobStopsTheOlderAndDropsItsResult) {
    std::promise<void> begun;
    LatestJob<int> jobs;
    jobs.start([&](const std::stop_token& stop) {
        begun.set_value();
        return run_until_stopped(stop);
    });
    begun.get_future().wait();
    EXPECT_TRUE(jobs.busy());
    jobs.start([](std::stop_token) { return 2; });
    EXPECT_EQ(wait_for(jobs), 2);
    std::this_thread::sleep_for(20ms);
    EXPECT_EQ(jobs.take(), std::nullopt);
}

TEST(LatestJob, ACanceledJobGivesNothing) {
    std::promise<void> begun;
    LatestJob<int> jobs;
    jobs.start([&](const std::stop_token& stop) {
        begun.set_value();
        return run_until_stopped(stop);
    });
    begun.get_future().wait();
    jobs.cancel();
    while (jobs.busy()) {
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(jobs.take(), std::nullopt);
    jobs.start([](std::stop_token) { return 3; });
    EXPECT_EQ(wait_for(jobs), 3);
}

TEST(LatestJob, AJobMayWaitForTheOneBefore) {
    std::promise<void> begun, go_on;
    LatestJob<int> jobs;
    jobs.start([&](const std::stop_token& stop) {
        begun.set_value();
        go_on.get_future().wait();
        return stop.stop_requested() ? -1 : 1;
    });
    begun.get_future().wait();
    std::promise<void> taken;
    jobs.start_after([&](std::stop_token) {
        taken.get_future().wait();
        return 2;
    });
    go_on.set_value();
    EXPECT_EQ(wait_for(jobs), 1) << "it was not stopped";
    taken.set_value();
    EXPECT_EQ(wait_for(jobs), 2);
}

TEST(LatestJob, AJobThatWaitsIsReplacedWithoutRunning) {
    std::promise<void> begun, go_on;
    std::atomic<int> ran{0};
    LatestJob<int> jobs;
    jobs.start([&](std::stop_token) {
        begun.set_value();
        go_on.get_future().wait();
        return 1;
    });
    begun.get_future().wait();
    for (int i = 2; i <= 4; ++i) {
        jobs.start([&ran, i](std::stop_token) {
            ++ran;
            return i;
        });
    }
    go_on.set_value();
    EXPECT_EQ(wait_for(jobs), 4);
    EXPECT_EQ(ran, 1);
}

TEST(LatestJob, ANewJobDropsAResultThatWasNotTaken) {
    std::promise<void> first_done;
    std::atomic<int> wakes{0};
    LatestJob<int> jobs([&] {
        if (++wakes == 1) {
            first_done.set_value();
        }
    });
    jobs.start([](std::stop_token) { return 1; });
    first_done.get_future().wait();
    jobs.start([](const std::stop_token& stop) { return run_until_stopped(stop); });
    EXPECT_EQ(jobs.take(), std::nullopt);
}

TEST(LatestJob, TheEndStopsTheJobThatRuns) {
    std::atomic<bool> stopped{false};
    {
        std::promise<void> begun;
        LatestJob<int> jobs;
        jobs.start([&](const std::stop_token& stop) {
            begun.set_value();
            (void)run_until_stopped(stop);
            stopped = true;
            return 0;
        });
        begun.get_future().wait();
    }
    EXPECT_TRUE(stopped);
}

TEST(LatestJob, ManyJobsInARowEndWithTheLast) {
    LatestJob<int> jobs;
    for (int i = 0; i <= 2000; ++i) {
        jobs.start([i](std::stop_token) { return i; });
    }
    EXPECT_EQ(wait_for(jobs), 2000);
}

}  // namespace
}  // namespace ui
