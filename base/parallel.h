// The same work on many things, on all cores.
#pragma once

#include <algorithm>
#include <atomic>

#include "base/stop.h"
#include "base/threads.h"

namespace base {

/// Calls work(i) once for each i from 0 to below `count`, on `threads` threads (0: one a core), in no order. Each
/// thread has a `work` of its own, made by `make()` on that thread. Returns when all is done; throws what one of them
/// has thrown, or Stopped when all threads have ended at the `stop` that was asked for.
template <typename Make>
void for_each_index(int count, const Make& make, unsigned threads = 0, const std::stop_token& stop = {}) {
    std::atomic<int> next{0};
    std::atomic<bool> given_up{false};
    on_threads(
        threads, static_cast<unsigned>(std::max(count, 1)),
        [&] {
            auto work = make();
            for (int i = next++; i < count && !given_up && !stop.stop_requested(); i = next++) {
                work(i);
            }
        },
        [&] { given_up = true; });
    end_if_asked(stop);
}

}  // namespace base
