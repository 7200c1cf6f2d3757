// The time that a run may take.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace ui {

/// Asks for a stop once the time is over. What then does not end by itself (some code of other people's libraries
/// cannot be interrupted) is ended by force a little later: the process exits with 1, temporary files removed, after
/// the same message.
class TimeLimit {
  public:
    /// From now on, less what another program has spent on the same run (kSpent). Not above 0 seconds: no limit.
    explicit TimeLimit(double seconds);

    /// Without state where there is no limit: nothing needs to be done in pieces then.
    [[nodiscard]] std::stop_token token() const { return limited_ ? stop_.get_token() : std::stop_token(); }
    [[nodiscard]] bool passed() const { return passed_; }  ///< The time was over.
    /// Says so on standard error, the first time.
    void tell();
    /// The run is done: what is left to do is not worth ending it by force.
    void end();
    [[nodiscard]] double spent() const;  ///< Seconds.

    /// The variable of the environment that says how many seconds another program, which has handed the run over, has
    /// spent on it.
    static constexpr const char* kSpent = "CSGSCOPE_SECONDS_SPENT";

  private:
    using Clock = std::chrono::steady_clock;
    void watch(const std::stop_token& done, Clock::time_point deadline);

    bool limited_;
    std::string text_;
    Clock::time_point start_;
    std::stop_source stop_;
    std::mutex mutex_;
    std::atomic<bool> passed_ = false;
    std::atomic_flag told_ = ATOMIC_FLAG_INIT;
    std::jthread thread_;
};

}  // namespace ui
