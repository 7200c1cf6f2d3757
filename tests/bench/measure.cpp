#include "tests/bench/measure.h"

#include <algorithm>
#include <ctime>
#include <vector>

namespace bench {

namespace {

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
    work();
    std::vector<double> wall, cpu;
    for (int i = 0; i < repeat; ++i) {
        const Time start = now();
        work();
        const Time spent = now() - start;
        wall.push_back(spent.wall);
        cpu.push_back(spent.cpu);
    }
    return {middle(wall), middle(cpu)};
}

}  // namespace bench
