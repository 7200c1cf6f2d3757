// The same work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace base {

/// Calls work() once on each of `threads` threads (0: one a core), at most `most` of them, this one included; on fewer
/// where the system gives no more. Returns when all have ended; what the first of them to throw has thrown is thrown
/// here. `give_up()` is called then, which must make the others end soon.
template <typename Work, typename GiveUp>
void on_threads(unsigned threads, unsigned most, const Work& work, const GiveUp& give_up) {
    std::atomic_flag failed = ATOMIC_FLAG_INIT;
    std::exception_ptr failure;
    const auto run = [&]() noexcept {
        try {
            work();
        } catch (...) {
            give_up();
            if (!failed.test_and_set()) {
                failure = std::current_exception();
            }
        }
    };
    const unsigned wanted = std::min(threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency()), most);
    {
        std::vector<std::jthread> helpers;
        helpers.reserve(wanted);
        try {
            while (helpers.size() + 1 < wanted) {
                helpers.emplace_back(run);
            }
        } catch (const std::system_error&) {
            // Fewer, then: no more threads,
        } catch (const std::bad_alloc&) {
            // or no more memory for one.
        }
        run();
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

}  // namespace base
