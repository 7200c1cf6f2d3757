// Wall and CPU time of a piece of work.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace bench {

/// Milliseconds. `cpu`: of all threads of the process, which is steadier than `wall` on a shared machine.
struct Time {
    double wall = 0;
    double cpu = 0;
};

[[nodiscard]] Time now();
[[nodiscard]] inline Time operator-(const Time& a, const Time& b) {
    return {a.wall - b.wall, a.cpu - b.cpu};
}

/// In CPU time.
[[nodiscard]] inline double ratio(const Time& a, const Time& b) {
    return a.cpu / std::max(b.cpu, 1e-3);
}

/// Runs `work` once to warm up and then `repeat` times, fewer where that takes longer than five seconds; the medians of
/// wall and of CPU time.
[[nodiscard]] Time median(int repeat, const std::function<void()>& work);

/// The same for several pieces of work, one after the other in every round: what else the machine does then falls on
/// all of them, and their ratios are steadier than those of figures taken one by one.
[[nodiscard]] std::vector<Time> interleaved(int repeat, const std::vector<std::function<void()>>& works);

}  // namespace bench
