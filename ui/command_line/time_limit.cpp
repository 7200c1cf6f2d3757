#include "ui/command_line/time_limit.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

#include "base/temporary_names.h"
#include "base/write_all.h"

namespace ui {

namespace {

using Seconds = std::chrono::duration<double>;

constexpr double kLongest = 1e9;  // More than a run ever takes, and what a clock can count.

/// How long after the stop was asked for the process is ended. The system takes about a tenth of a second to take back
/// a gigabyte.
Seconds grace() {
    constexpr double kMost = 0.2, kLeast = 0.05, kPerGibibyte = 0.1;
    std::ifstream in("/proc/self/statm");
    double size = 0, resident = 0;
    in >> size >> resident;
    const double gibibytes = resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 0x1p30;
    return Seconds(std::clamp(kMost - kPerGibibyte * gibibytes, kLeast, kMost));
}

/// What other programs have spent on this run; told once.
Seconds spent_before() {
    const char* const text = std::getenv(TimeLimit::kSpent);
    const double seconds = text != nullptr ? std::strtod(text, nullptr) : 0;
    unsetenv(TimeLimit::kSpent);
    return Seconds(std::clamp(seconds, 0.0, kLongest));
}

/// Whatever the other threads hold, and whether or not anybody reads: this does not wait.
void write_at_once(const std::string& text) {
    pollfd error{STDERR_FILENO, POLLOUT, 0};
    if (poll(&error, 1, 0) == 1 && (error.revents & POLLOUT) != 0) {
        [[maybe_unused]] const bool written = base::write_all(STDERR_FILENO, text, 0);
    }
}

}  // namespace

TimeLimit::TimeLimit(double seconds)
    : limited_(seconds > 0),
      text_(fmt::format("csgscope: error: --time-limit: not done after {} seconds\n", seconds)),
      start_(Clock::now() - std::chrono::duration_cast<Clock::duration>(spent_before())) {
    if (limited_) {
        const auto deadline =
            start_ + std::chrono::duration_cast<Clock::duration>(Seconds(std::min(seconds, kLongest)));
        thread_ = std::jthread([this, deadline](const std::stop_token& done) { watch(done, deadline); });
    }
}

void TimeLimit::watch(const std::stop_token& done, Clock::time_point deadline) {
    const auto wait_until = [&](Clock::time_point time) {
        std::unique_lock lock(mutex_);
        std::condition_variable_any never;
        (void)never.wait_until(lock, done, time, [] { return false; });
        return !done.stop_requested();
    };
    if (!wait_until(deadline)) {
        return;
    }
    passed_ = true;
    stop_.request_stop();
    if (wait_until(Clock::now() + std::chrono::duration_cast<Clock::duration>(grace()))) {
        tell();
        base::remove_temporary_names();
        _exit(1);
    }
}

void TimeLimit::tell() {
    if (!told_.test_and_set()) {
        write_at_once(text_);
    }
}

void TimeLimit::end() {
    if (thread_.joinable()) {
        thread_.request_stop();
        thread_.join();
    }
}

double TimeLimit::spent() const {
    return Seconds(Clock::now() - start_).count();
}

}  // namespace ui
