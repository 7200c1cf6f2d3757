// Random numbers that are the same wherever they are drawn, which the standard's distributions are not.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace meshes {

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double number(double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
    int whole(int lo, int hi) { return static_cast<int>(std::floor(number(lo, hi + 1))); }
    bool chance(double p) { return number(0, 1) < p; }
    /// "[x,y,z]", as programs have it.
    std::string vector(double lo, double hi) {
        return fmt::format("[{:.3g},{:.3g},{:.3g}]", number(lo, hi), number(lo, hi), number(lo, hi));
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace meshes
