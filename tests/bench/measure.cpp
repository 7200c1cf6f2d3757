#include "tests/bench/measure.h"

#include <algorithm>
#include <ctime>
#include <vector>

namespace bench {

namespace {

/// Milliseconds after which no further round begins.
constexpr double kLongest = 5000;

double milliseconds(clockid_t clock) {
    timespec t{};
    clock_gettime(clock, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

double middle(std::vector<double>& values) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace

Time now() {
    return {milliseconds(CLOCK_MONOTONIC), milliseconds(CLOCK_PROCESS_CPUTIME_ID)};
}

Time median(int repeat, const std::function<void()>& work) {
    return interleaved(repeat, {work}).front();
}

std::vector<Time> interleaved(int repeat, const std::vector<std::function<void()>>& works) {
    for (const auto& work : works) {
        work();
    }
    std::vector<std::vector<double>> wall(works.size()), cpu(works.size());
    const double end = now().wall + kLongest;
    for (int round = 0; round == 0 || (round < repeat && now().wall < end); ++round) {
        for (std::size_t i = 0; i < works.size(); ++i) {
            const Time start = now();
            works[i]();
            const Time spent = now() - start;
            wall[i].push_back(spent.wall);
            cpu[i].push_back(spent.cpu);
        }
    }
    std::vector<Time> medians;
    for (std::size_t i = 0; i < works.size(); ++i) {
        medians.push_back({middle(wall[i]), middle(cpu[i])});
    }
    return medians;
}

}  // namespace bench
