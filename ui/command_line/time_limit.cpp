#include "ui/command_line/time_limit.h"

#include <chrono>

#include <fmt/format.h>

namespace ui {

TimeLimit::TimeLimit(double seconds, std::stop_source stop)
    : thread_([this, seconds, stop = std::move(stop)](const std::stop_token& done) mutable {
          std::unique_lock lock(mutex_);
          std::condition_variable_any never;
          if (!never.wait_for(lock, done, std::chrono::duration<double>(seconds), [] { return false; }) &&
              !done.stop_requested()) {
              passed_ = true;
              stop.request_stop();
          }
      }) {}

std::string time_limit_passed(double seconds) {
    return fmt::format("--time-limit: not done after {} seconds", seconds);
}

}  // namespace ui
