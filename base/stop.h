// Work that can be asked to end before it is done. Below everything: every folder may include it.
#pragma once

#include <cstdint>
#include <stop_token>

namespace base {

/// Thrown by work that was asked to stop. It is no error, and no std::exception: what handles errors on the way lets it
/// pass. What the work was making is not to be read; all it works with can be used for the next.
struct Stopped {};

/// Throws Stopped where it was asked for.
inline void end_if_asked(const std::stop_token& stop) {
    if (stop.stop_requested()) {
        throw Stopped();
    }
}

/// For loops whose rounds take less than a microsecond: looks at the token once in 1024 calls. The token must outlive
/// it.
class PacedStop {
  public:
    explicit PacedStop(const std::stop_token& stop) : stop_(stop) {}
    void operator()() {
        if ((++calls_ & 1023U) == 0) {
            end_if_asked(stop_);
        }
    }

  private:
    const std::stop_token& stop_;
    std::uint32_t calls_ = 0;
};

}  // namespace base
