// Work that can be asked to end before it is done.
#pragma once

#include <exception>
#include <stop_token>

namespace gl {

/// Thrown by work that was asked to stop: no error. What it was making is not to be read; all it works with can be used
/// for the next.
class Stopped : public std::exception {
  public:
    [[nodiscard]] const char* what() const noexcept override { return "stopped"; }
};

/// Throws Stopped where it was asked for.
inline void end_if_asked(const std::stop_token& stop) {
    if (stop.stop_requested()) {
        throw Stopped();
    }
}

}  // namespace gl
