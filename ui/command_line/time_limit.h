// The time that a run may take.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace ui {

/// Asks for a stop once the time is over, unless it is destroyed before.
class TimeLimit {
  public:
    /// At once where the time is not above 0.
    TimeLimit(double seconds, std::stop_source stop);
    /// The time was over.
    [[nodiscard]] bool passed() const { return passed_; }

  private:
    std::mutex mutex_;
    std::atomic<bool> passed_ = false;
    std::jthread thread_;
};

/// What is told then.
[[nodiscard]] std::string time_limit_passed(double seconds);

}  // namespace ui
