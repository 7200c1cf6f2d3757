// The Mersenne Twister of 32 bits (Matsumoto and Nishimura 1998), which works out its state as far as it is asked for:
// programs seed one for a few numbers, thousands of times.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace csg::scad {

/// A generator of random bits as std::mt19937 is, with the same sequence. To be seeded before it is asked.
class SeededRandom {
  public:
    using result_type = std::uint32_t;
    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return 0xffffffffU; }

    void seed(std::uint32_t value) {
        seed_ = value;
        at_ = 0;
        known_ = 0;
        starts_.resize(kStarts);
        Start& start = starts_[value % kStarts];
        if (start.known && start.seed == value) {
            std::copy(start.first.begin(), start.first.end(), state_.begin());
            std::copy(start.shifted.begin(), start.shifted.end(), state_.begin() + kShift);
            return;
        }
        know(kShift + kFew);
        start.known = true;
        start.seed = value;
        std::copy_n(state_.begin(), start.first.size(), start.first.begin());
        std::copy_n(state_.begin() + kShift, start.shifted.size(), start.shifted.begin());
    }

    result_type operator()() {
        if (at_ == kSize) {
            at_ = 0;
        }
        if (known_ < kSize && at_ >= kFew) {
            know(std::min(kSize, at_ + kShift + 1));
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
    static constexpr std::size_t kFew = 6;       ///< Numbers of 32 bits that are found again: three of rands().
    static constexpr std::size_t kStarts = 512;  ///< Noise asks for the same few seeds again and again.

    /// Of a seed that was used before, what the first few numbers take of the state.
    struct Start {
        bool known = false;
        std::uint32_t seed = 0;
        std::array<std::uint32_t, kFew + 1> first{};
        std::array<std::uint32_t, kFew> shifted{};
    };

    /// Works out the first `count` words of the state but those that have given their number.
    void know(std::size_t count) {
        std::uint32_t word = known_ == 0 ? seed_ : last_;
        for (std::size_t i = known_; i < count; ++i) {
            word = i == 0 ? seed_ : 1812433253U * (word ^ word >> 30) + static_cast<std::uint32_t>(i);
            if (i >= at_) {
                state_[i] = word;
            }
        }
        known_ = std::max(known_, count);
        last_ = word;
    }

    std::array<std::uint32_t, kSize> state_;  // Not set: most of it is never needed.
    std::vector<Start> starts_;               ///< By seed modulo their number.
    std::uint32_t seed_ = 0;
    std::uint32_t last_ = 0;  ///< The last word of the state that is known, as it was at first.
    std::size_t known_ = 0;   ///< How many words of the state have been worked out.
    std::size_t at_ = 0;
};

}  // namespace csg::scad
