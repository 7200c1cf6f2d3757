// Wall and CPU time of a piece of work.
#pragma once

#include <algorithm>
#include <functional>

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

/// Runs `work` once to warm up and then `repeat` times; the medians of wall and of CPU time.
[[nodiscard]] Time median(int repeat, const std::function<void()>& work);

}  // namespace bench
