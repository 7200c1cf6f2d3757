// The same work on many things, on all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "gl/stop.h"

namespace gl {

/// Calls work(i) once for each i from 0 to below `count`, on `threads` threads (0: one a core), in no order. Each
/// thread has a `work` of its own, made by `make()` on that thread. Neither may throw. Returns when all is done, or
/// throws Stopped when all threads have ended at the `stop` that was asked for.
template <typename Make>
void for_each_index(int count, const Make& make, unsigned threads = 0, const std::stop_token& stop = {}) {
    std::atomic<int> next{0};
    const auto run = [&] {
        auto work = make();
        for (int i = next++; i < count && !stop.stop_requested(); i = next++) {
            work(i);
        }
    };
    const unsigned wanted = threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
    {
        std::vector<std::jthread> helpers;
        for (unsigned i = 1; i < std::min(wanted, static_cast<unsigned>(std::max(count, 1))); ++i) {
            helpers.emplace_back(run);
        }
        run();
    }
    end_if_asked(stop);
}

}  // namespace gl
