#include "csg/scad/program/deep_thread.h"

#include <pthread.h>

#include <algorithm>

namespace csg::scad {

namespace {

constexpr std::size_t kSmallestStack = std::size_t{16} << 20;
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t kLargestStack = std::size_t{60} << 20;  // The sanitizer loses track when more is unwound at once.
#else
constexpr std::size_t kLargestStack = std::size_t{64} << 30;
#endif
constexpr std::size_t kStackReserve = std::size_t{4} << 20;  // For what runs without asking: built-ins, messages.

struct ThreadStart {
    const std::function<void(const char*)>& work;
    std::size_t stack_bytes;
};

void* run_on_thread(void* argument) {
    const auto& start = *static_cast<ThreadStart*>(argument);
    const char top = 0;
    start.work(&top - (start.stack_bytes - kStackReserve));
    return nullptr;
}

}  // namespace

bool run_deep(std::size_t stack_bytes, const std::function<void(const char* stack_limit)>& work) {
    ThreadStart start{work, std::clamp(stack_bytes, kSmallestStack, kLargestStack)};
    pthread_attr_t attributes;
    pthread_t thread{};
    pthread_attr_init(&attributes);
    const bool started = pthread_attr_setstacksize(&attributes, start.stack_bytes) == 0 &&
                         pthread_create(&thread, &attributes, run_on_thread, &start) == 0;
    pthread_attr_destroy(&attributes);
    if (started) {
        pthread_join(thread, nullptr);
    }
    return started;
}

}  // namespace csg::scad
