#include "ui/command_line/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>

namespace ui {

namespace {

struct Held {
    std::size_t code = 0;  ///< Of files, in memory.
    std::size_t data = 0;  ///< Of what RLIMIT_DATA limits.
};

Held held() {
    std::ifstream in("/proc/self/statm");
    std::array<std::size_t, 6> pages{};  // Size, resident, shared, text, library, data and stack.
    for (std::size_t& number : pages) {
        in >> number;
    }
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return in ? Held{pages[2] * page, pages[5] * page} : Held{};
}

}  // namespace

void limit_memory(std::size_t bytes) {
    const Held now = held();
    const rlim_t data = std::max(now.data, bytes - std::min(bytes, now.code));
    rlimit limit{};
    if (getrlimit(RLIMIT_DATA, &limit) == 0) {
        limit.rlim_cur = limit.rlim_max == RLIM_INFINITY ? data : std::min(data, limit.rlim_max);
        (void)setrlimit(RLIMIT_DATA, &limit);
    }
}

}  // namespace ui
