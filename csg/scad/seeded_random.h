// The Mersenne Twister of 32 bits (Matsumoto and Nishimura 1998), which works out its state as far as it is asked for:
// programs seed one for a few numbers, thousands of times.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace csg::scad {

/// A generator of random bits as std::mt19937 is, with the same sequence. To be seeded before it is asked.
class SeededRandom {
  public:
    using result_type = std::uint32_t;
    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return 0xffffffffU; }

    void seed(std::uint32_t value) {
        state_[0] = value;
        known_ = 1;
        at_ = 0;
    }

    result_type operator()() {
        if (at_ == kSize) {
            at_ = 0;
        }
        while (known_ < kSize && known_ <= at_ + kShift) {
            const std::uint32_t before = state_[known_ - 1];
            state_[known_] = 1812433253U * (before ^ before >> 30) + static_cast<std::uint32_t>(known_);
            ++known_;
        }
        const std::uint32_t mixed = (state_[at_] & 0x80000000U) | (state_[(at_ + 1) % kSize] & 0x7fffffffU);
        state_[at_] = state_[(at_ + kShift) % kSize] ^ mixed >> 1 ^ ((mixed & 1U) != 0 ? 0x9908b0dfU : 0U);
        std::uint32_t y = state_[at_++];
        y ^= y >> 11;
        y ^= y << 7 & 0x9d2c5680U;
        y ^= y << 15 & 0xefc60000U;
        return y ^ y >> 18;
    }

  private:
    static constexpr std::size_t kSize = 624;
    static constexpr std::size_t kShift = 397;
    std::array<std::uint32_t, kSize> state_;  // Not set: most of it is never needed.
    std::size_t known_ = 0;                   ///< How many words of the state have been worked out.
    std::size_t at_ = 0;
};

}  // namespace csg::scad
