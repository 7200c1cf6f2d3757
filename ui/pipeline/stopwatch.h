// Wall time of a stage.
#pragma once

#include <chrono>
#include <utility>

namespace ui {

class Stopwatch {
  public:
    /// Milliseconds since the start or the last lap.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double, std::milli>(now - std::exchange(start_, now)).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace ui
